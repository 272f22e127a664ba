// OFF: counts, vertices, polygons; colours and normals are passed over.
#include <fmt/format.h>

#include "exchange/soup.h"
#include "exchange/words.h"

namespace lamella::exchange {

namespace {

// `OFF`, `COFF`, `NOFF` and the like; the counts may stand on the same line.
bool is_header(std::string_view word) {
  return word.ends_with("OFF") && word.size() <= 6;
}

long count(const WordReader& lines, std::size_t i, std::string_view what) {
  const long value = lines.whole(i, what);
  constexpr long most = 1L << 30;
  if (value < 0 || value > most) lines.fail(i, fmt::format("{} cannot be {}", what, value));
  return value;
}

void polygon(const WordReader& lines, Soup& soup) {
  const long corners = count(lines, 0, "the number of corners");
  if (corners < 3) lines.fail(0, fmt::format("a face of {} corners is no face", corners));
  std::vector<std::uint32_t> polygon;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(corners); ++i) {
    const long v = lines.whole(i, "a vertex");
    if (v < 0 || v >= static_cast<long>(soup.points.size()))
      lines.fail(i, fmt::format("there is no vertex {}", v),
                 fmt::format("vertices count from 0 to {}", soup.points.size() - 1));
    polygon.push_back(static_cast<std::uint32_t>(v));
  }
  soup.add_polygon(polygon);
}

}  // namespace

Soup read_off(const std::string& path, std::string content) {
  WordReader lines(path, std::move(content), '#');
  if (!lines.next_line()) lines.fail_at_end("the file is empty");
  std::size_t first = 0;
  if (is_header(lines.word(0))) {
    if (lines.word(0).find_first_of("4n") != std::string_view::npos)
      lines.fail(0, "only points of three coordinates can be imported");
    if (lines.count() > 1) {
      first = 1;
    } else if (!lines.next_line()) {
      lines.fail_at_end("the file ends before its counts");
    }
  }
  const long vertices = count(lines, first, "the number of vertices");
  const long faces = count(lines, first + 1, "the number of faces");
  Soup soup;
  for (long i = 0; i < vertices; ++i) {
    if (!lines.next_line()) lines.fail_at_end(fmt::format("vertex {} of {} is missing", i, vertices));
    soup.points.push_back(
        {lines.number(0, "a coordinate"), lines.number(1, "a coordinate"), lines.number(2, "a coordinate")});
  }
  for (long i = 0; i < faces; ++i) {
    if (!lines.next_line()) lines.fail_at_end(fmt::format("face {} of {} is missing", i, faces));
    polygon(lines, soup);
  }
  return soup;
}

}  // namespace lamella::exchange
