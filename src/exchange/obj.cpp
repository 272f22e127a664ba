#include "exchange/obj.h"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>

namespace lamella::exchange {

namespace {

constexpr std::string_view first_line = "# made by Lamella: soap films\n";

using Writer = std::back_insert_iterator<std::string>;

void vertex(Writer out, const film::Vec3& p) {
  fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
}

void face(Writer out, const Triple& t) {
  fmt::format_to(out, "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
}

}  // namespace

std::string write_obj(const Mesh& mesh) {
  std::string text(first_line);
  const Writer out(text);
  for (const film::Vec3& p : mesh.points) vertex(out, p);
  std::map<std::array<std::uint32_t, 2>, std::vector<Triple>> groups;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t front = mesh.regions[i].front.index;
    const std::uint32_t behind = mesh.regions[i].behind.index;
    const Triple& t = mesh.triangles[i];
    groups[{std::min(front, behind), std::max(front, behind)}].push_back(
        front <= behind ? t : Triple{t[0], t[2], t[1]});
  }
  for (const auto& [pair, triangles] : groups) {
    fmt::format_to(out, "g film_{}_{}\n", pair[0], pair[1]);
    for (const Triple& t : triangles) face(out, t);
  }
  std::string group;
  for (const Line& line : mesh.lines) {
    if (group != name_of(line.kind)) {
      group = name_of(line.kind);
      text += "g " + group + "\n";
    }
    text += "l";
    for (const std::uint32_t p : line.points) fmt::format_to(out, " {}", p + 1);
    text += "\n";
  }
  return text;
}

std::string write_obj(const Mesh& mesh, const Part& part) {
  std::string text(first_line);
  const Writer out(text);
  for (const std::uint32_t p : part.points) vertex(out, mesh.points[p]);
  fmt::format_to(out, "g body_{}\n", part.regions.behind.index);
  for (const Triple& t : part.triangles) face(out, t);
  return text;
}

}  // namespace lamella::exchange
