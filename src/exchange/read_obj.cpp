// Wavefront OBJ: vertices, faces and lines; the rest of the format says nothing about shape.
#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "exchange/soup.h"
#include "exchange/words.h"

namespace lamella::exchange {

namespace {

using film::Region;
using film::RegionPair;

constexpr std::string_view passed_over[] = {
    "vn", "vt",     "vp",     "o",     "s",        "mg",       "usemtl",     "mtllib",   "lod",
    "p",  "usemap", "maplib", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(const std::string& path, std::string content) : lines_(path, joined(std::move(content)), '#') {}

  Soup read() {
    while (lines_.next_line()) {
      if (lines_.word(0) == "v") ++vertices_;
    }
    lines_.rewind();
    while (lines_.next_line()) statement();
    // Regions are known where every face stands in a group that names them.
    if (soup_.regions.size() != soup_.size()) soup_.regions.clear();
    return std::move(soup_);
  }

 private:
  // A line that ends in a backslash goes on; places stay what they are.
  static std::string joined(std::string content) {
    for (std::size_t at = content.find("\\\n"); at != std::string::npos; at = content.find("\\\n", at + 2))
      content[at] = content[at + 1] = ' ';
    return content;
  }

  void statement() {
    const std::string_view word = lines_.word(0);
    if (word == "v") {
      vertex();
    } else if (word == "f") {
      face();
    } else if (word == "l") {
      line();
    } else if (word == "g") {
      group();
    } else if (std::find(std::begin(passed_over), std::end(passed_over), word) == std::end(passed_over)) {
      lines_.fail(0, fmt::format("\"{}\" is no statement of an OBJ file that can be imported", word),
                  "v, f, l and g are read; normals, textures and materials are passed over");
    }
  }

  void vertex() {
    soup_.points.push_back({lines_.number(1, "a coordinate"), lines_.number(2, "a coordinate"),
                            lines_.number(3, "a coordinate")});
  }

  // `7`, `7/1`, `7//3` or `-1`, counted back from the vertex before.
  std::uint32_t index(std::size_t i) {
    const std::string_view word = lines_.word(i).substr(0, lines_.word(i).find('/'));
    long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value == 0)
      lines_.fail(i, fmt::format("\"{}\" is no vertex", lines_.word(i)), "vertices count from 1");
    const long row = value > 0 ? value - 1 : static_cast<long>(soup_.points.size()) + value;
    if (row < 0 || row >= vertices_)
      lines_.fail(i, fmt::format("there is no vertex {}", value), fmt::format("the file has {}", vertices_));
    return static_cast<std::uint32_t>(row);
  }

  void face() {
    if (lines_.count() < 4) lines_.fail(lines_.count(), "a face has three corners or more");
    std::vector<std::uint32_t> polygon;
    for (std::size_t i = 1; i < lines_.count(); ++i) polygon.push_back(index(i));
    soup_.add_polygon(polygon);
    if (pair_) soup_.regions.push_back(*pair_);
  }

  void line() {
    for (std::size_t i = 2; i < lines_.count(); ++i) {
      soup_.wires.push_back({index(i - 1), index(i)});
      soup_.wire_kinds.push_back(line_kind_);
    }
  }

  // The names that `export` gives: film_A_B, border, rim, wire.
  void group() {
    const std::string_view name = lines_.count() > 1 ? lines_.word(1) : std::string_view{};
    line_kind_ = name == "border" || name == "rim" ? WireKind::line : WireKind::wire;
    pair_.reset();
    std::uint32_t front = 0;
    std::uint32_t behind = 0;
    if (!name.starts_with("film_")) return;
    const char* const end = name.data() + name.size();
    const auto first = std::from_chars(name.data() + 5, end, front);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '_') return;
    const auto second = std::from_chars(first.ptr + 1, end, behind);
    if (second.ec == std::errc() && second.ptr == end) pair_ = RegionPair{Region{front}, Region{behind}};
  }

  WordReader lines_;
  Soup soup_;
  long vertices_ = 0;
  std::optional<RegionPair> pair_;
  WireKind line_kind_ = WireKind::wire;
};

}  // namespace

Soup read_obj(const std::string& path, std::string content) {
  return ObjReader(path, std::move(content)).read();
}

}  // namespace lamella::exchange
