// Polygons as files have them: loose, or sharing points by number.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "film/ids.h"
#include "film/vec3.h"

namespace lamella::exchange {

enum class WireKind : std::uint8_t {
  wire,  // fixed
  line,  // a border or rim that an earlier export wrote: known from the films anyway
};

struct Soup {
  std::vector<film::Vec3> points;
  std::vector<std::uint32_t> corners;     // of all polygons, one after the other
  std::vector<std::uint32_t> ends;        // where the corners of each polygon end
  std::vector<film::RegionPair> regions;  // one a polygon, or none
  std::vector<std::array<std::uint32_t, 2>> wires;
  std::vector<WireKind> wire_kinds;  // one a wire

  std::size_t size() const { return ends.size(); }
  void add_polygon(const std::vector<std::uint32_t>& polygon) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

// By the path's ending: .obj, .ply, .stl or .off. Throws text::Error, with the place where the file is text.
Soup read_soup(const std::string& path);

// `content` is that of a file with this path. One function a format.
Soup read_obj(const std::string& path, std::string content);
Soup read_off(const std::string& path, std::string content);
Soup read_ply(const std::string& path, std::string content);
Soup read_stl(const std::string& path, std::string content);

// Two whole numbers for each of `count` polygons: the regions in front and behind. `#` begins a comment.
std::vector<film::RegionPair> read_labels(const std::string& path, std::size_t count);

}  // namespace lamella::exchange
