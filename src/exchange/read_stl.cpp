// STL, binary and text: triangles that share nothing.
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "exchange/soup.h"
#include "exchange/words.h"

namespace lamella::exchange {

namespace {

constexpr std::size_t header = 80;
constexpr std::size_t row = 50;

std::uint32_t count_of(const std::string& content) {
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + header, sizeof count);
  return count;
}

// Both kinds may begin with `solid`: the length decides.
bool is_binary(const std::string& content) {
  return content.size() >= header + 4 && content.size() == header + 4 + row * count_of(content);
}

void add_triangle(Soup& soup, const std::array<film::Vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), corners.begin(), corners.end());
  soup.add_polygon({first, first + 1, first + 2});
}

Soup read_binary(const std::string& path, const std::string& content) {
  Soup soup;
  const std::uint32_t count = count_of(content);
  for (std::uint32_t t = 0; t < count; ++t) {
    float numbers[12];
    std::memcpy(numbers, content.data() + header + 4 + row * t, sizeof numbers);
    std::array<film::Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]};
      if (!is_finite(corners[k]))
        throw text::Error(fmt::format("\"{}\": facet {} has a corner at no place", path, t + 1));
    }
    add_triangle(soup, corners);
  }
  return soup;
}

Soup read_text(const std::string& path, std::string content) {
  WordReader lines(path, std::move(content), '\0');
  Soup soup;
  std::vector<film::Vec3> corners;
  if (!lines.next_line()) lines.fail_at_end("the file is empty");
  if (lines.word(0) != "solid") {
    throw text::Error(fmt::format("\"{}\" is no STL file", path),
                      "text begins with the word solid; a binary file has 84 bytes and 50 for each facet");
  }
  while (lines.next_line()) {
    const std::string_view word = lines.word(0);
    if (word == "facet") corners.clear();
    if (word == "vertex") {
      corners.push_back({lines.number(1, "a coordinate"), lines.number(2, "a coordinate"),
                         lines.number(3, "a coordinate")});
    } else if (word == "endfacet") {
      if (corners.size() != 3) lines.fail(0, fmt::format("a facet of {} corners", corners.size()));
      add_triangle(soup, {corners[0], corners[1], corners[2]});
      corners.clear();
    } else if (word != "facet" && word != "outer" && word != "endloop" && word != "endsolid" &&
               word != "solid") {
      lines.fail(0, fmt::format("\"{}\" is no word of an STL file", word));
    }
  }
  if (!corners.empty()) lines.fail_at_end("the last facet is not complete");
  return soup;
}

}  // namespace

Soup read_stl(const std::string& path, std::string content) {
  return is_binary(content) ? read_binary(path, content) : read_text(path, std::move(content));
}

}  // namespace lamella::exchange
