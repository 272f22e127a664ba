#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "exchange/soup.h"
#include "exchange/words.h"
#include "text/suggest.h"
#include "text/whole_file.h"

namespace lamella::exchange {

Soup read_soup(const std::string& path) {
  const std::string ending = text::lower(std::filesystem::path(path).extension().string());
  if (ending == ".obj") return read_obj(path, text::read_whole_file(path));
  if (ending == ".ply") return read_ply(path, text::read_whole_file(path));
  if (ending == ".stl") return read_stl(path, text::read_whole_file(path));
  if (ending == ".off") return read_off(path, text::read_whole_file(path));
  throw text::Error(
      ending.empty() ? "the ending of the file's name tells the format, and there is none"
                     : fmt::format("files of the kind \"{}\" cannot be imported", ending),
      ending == ".fe" ? "a datafile is loaded: load FILE.fe" : "known are .obj, .ply, .stl, .off");
}

std::vector<film::RegionPair> read_labels(const std::string& path, std::size_t count) {
  WordReader lines(path, text::read_whole_file(path), '#');
  std::vector<film::RegionPair> pairs;
  const auto region = [&](std::size_t i) {
    const long value = lines.whole(i, i == 0 ? "the region in front" : "the region behind");
    if (value < 0 || value > static_cast<long>(2 * count))
      lines.fail(i, fmt::format("a region cannot be {}", value),
                 "regions count from 0, which is the outside; no more of them than sides of facets");
    return film::Region{static_cast<std::uint32_t>(value)};
  };
  while (lines.next_line()) {
    if (pairs.size() == count) lines.fail(0, fmt::format("there are only {} facets to label", count));
    pairs.push_back({region(0), region(1)});
    if (lines.count() > 2) lines.fail(2, "two numbers label a facet: the regions in front and behind");
  }
  if (pairs.size() < count)
    lines.fail_at_end(fmt::format("{} facets are labelled, and there are {}", pairs.size(), count));
  return pairs;
}

}  // namespace lamella::exchange
