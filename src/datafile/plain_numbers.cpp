#include "datafile/plain_numbers.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "datafile/spot.h"

namespace lamella::datafile {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ':' || c == ';';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool ends_number(std::string_view content, std::size_t at) {
  if (at >= content.size()) return true;
  const char c = content[at];
  return is_space(c) || c == '\n' || c == '\r' || c == '}' ||
         (c == '\\' && line_end_length(content, at + 1) > 0);
}

// The length of a whole number of few digits that stands alone; 0 if there is none. Most numbers of a
// datafile are numbers of elements.
std::uint32_t plain_whole(std::string_view content, std::size_t at, double& value) {
  constexpr std::size_t most_digits = 9;
  std::uint32_t number = 0;
  std::size_t end = at;
  for (; end < content.size() && end < at + most_digits && is_digit(content[end]); ++end) {
    number = 10 * number + static_cast<std::uint32_t>(content[end] - '0');
  }
  if (end == at || !ends_number(content, end)) return 0;
  value = number;
  return static_cast<std::uint32_t>(end - at);
}

}  // namespace

std::uint32_t line_end_length(std::string_view content, std::size_t at) {
  if (at >= content.size()) return 0;
  if (content[at] == '\n') return 1;
  if (content[at] != '\r') return 0;
  return at + 1 < content.size() && content[at + 1] == '\n' ? 2 : 1;
}

std::uint32_t skip_blanks(std::string_view content, std::uint32_t at) {
  while (at < content.size()) {
    if (is_space(content[at])) {
      ++at;
    } else if (content[at] == '\\' && line_end_length(content, at + 1) > 0) {
      at += 1 + line_end_length(content, at + 1);
    } else {
      break;
    }
  }
  return at;
}

std::uint32_t plain_number(std::string_view content, std::size_t at, double& value) {
  constexpr std::uint32_t longest = std::numeric_limits<std::uint16_t>::max();  // of a Spot
  const std::uint32_t sign = at < content.size() && content[at] == '-' ? 1 : 0;
  if (const std::uint32_t digits = plain_whole(content, at + sign, value)) {
    if (sign != 0) value = -value;
    return sign + digits;
  }
  const std::string_view rest = content.substr(std::min(at + sign, content.size()), 2);
  const bool begins =
      !rest.empty() && (is_digit(rest[0]) || (rest.size() == 2 && rest[0] == '.' && is_digit(rest[1])));
  if (!begins) return 0;
  const char* const first = content.data() + at;
  const auto [last, code] = std::from_chars(first, content.data() + content.size(), value);
  const auto length = static_cast<std::size_t>(last - first);
  if (code != std::errc{} || length > longest || !ends_number(content, at + length)) return 0;
  return static_cast<std::uint32_t>(length);
}

}  // namespace lamella::datafile
