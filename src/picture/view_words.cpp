#include "picture/view_words.h"

#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "text/error.h"
#include "text/suggest.h"

namespace lamella::picture {

namespace {

struct NamedView {
  std::string_view name;
  film::Vec3 from;
};

constexpr std::array<NamedView, 7> views = {{{"front", {0, -1, 0}},
                                             {"back", {0, 1, 0}},
                                             {"left", {-1, 0, 0}},
                                             {"right", {1, 0, 0}},
                                             {"top", {0, 0, 1}},
                                             {"bottom", {0, 0, -1}},
                                             {"corner", {1, -1.2, 0.8}}}};

constexpr std::string_view heading = "lamella view 1";

}  // namespace

std::vector<std::string> view_names() {
  std::vector<std::string> names;
  for (const NamedView& view : views) names.emplace_back(view.name);
  return names;
}

Rotation rotation_named(std::string_view name) {
  for (const NamedView& view : views) {
    // From above and below, x points to the right.
    if (view.name != name) continue;
    if (name == "top") return {};
    if (name == "bottom") return about({1, 0, 0}, M_PI);
    return looking_from(view.from);
  }
  const std::vector<std::string> names = view_names();
  const std::string near = text::did_you_mean(name, names);
  throw text::Error(fmt::format("there is no view \"{}\"", name),
                    near.empty()
                        ? fmt::format("views are {}, and files written by view save", fmt::join(names, ", "))
                        : near);
}

Rotation turned(const Rotation& rotation, double right, double up, double roll) {
  constexpr double degree = M_PI / 180;
  return about({0, 0, 1}, roll * degree) * about({1, 0, 0}, -up * degree) * about({0, 1, 0}, right * degree) *
         rotation;
}

std::string write_view(const View& view) {
  const Rotation& q = view.rotation;
  return fmt::format("{}\nrotation {} {} {} {}\nzoom {}\npan {} {}\nlens {}\n", heading, q.w, q.x, q.y, q.z,
                     view.zoom, view.right, view.up, view.field_of_view);
}

View read_view(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::string line;
  std::getline(stream, line);
  View view;
  Rotation& q = view.rotation;
  std::array<std::string, 4> words;
  stream >> words[0] >> q.w >> q.x >> q.y >> q.z >> words[1] >> view.zoom >> words[2] >> view.right >>
      view.up >> words[3] >> view.field_of_view;
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  const bool right_words = words == std::array<std::string, 4>{"rotation", "zoom", "pan", "lens"};
  const bool sound = norm > 0.5 && norm < 2 && view.zoom > 0 && std::isfinite(view.right + view.up) &&
                     view.field_of_view >= 0 && view.field_of_view < 170;
  if (line != heading || !stream || !right_words || !sound) {
    throw text::Error("this is no saved view", "a view is written by: view save FILE");
  }
  q = {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
  return view;
}

}  // namespace lamella::picture
