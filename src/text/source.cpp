#include "text/source.h"

#include <algorithm>

namespace lamella::text {

namespace {

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::size_t line_start(std::string_view content, std::size_t offset) {
  while (offset > 0 && !is_line_end(content[offset - 1])) --offset;
  return offset;
}

std::size_t clamped_offset(const Place& place) {
  return std::min<std::size_t>(place.offset, place.source->content.size());
}

}  // namespace

SourcePointer make_source(std::string name, std::string content) {
  return std::make_shared<const Source>(Source{std::move(name), std::move(content)});
}

LineColumn line_and_column(const Place& place) {
  if (!place.known()) return {};
  const std::string_view content = place.source->content;
  const std::size_t offset = clamped_offset(place);
  LineColumn result;
  for (std::size_t i = 0; i < offset; ++i) {
    const bool first_half_of_crlf = content[i] == '\r' && i + 1 < content.size() && content[i + 1] == '\n';
    if (is_line_end(content[i]) && !first_half_of_crlf) ++result.line;
  }
  for (std::size_t i = line_start(content, offset); i < offset; ++i) {
    if (!continues_character(content[i])) ++result.column;
  }
  return result;
}

std::string_view line_of(const Place& place) {
  if (!place.known()) return {};
  const std::string_view content = place.source->content;
  const std::size_t start = line_start(content, clamped_offset(place));
  std::size_t end = start;
  while (end < content.size() && !is_line_end(content[end])) ++end;
  return content.substr(start, end - start);
}

}  // namespace lamella::text
