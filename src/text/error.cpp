#include "text/error.h"

#include <algorithm>

#include <fmt/format.h>

namespace lamella::text {

namespace {

constexpr std::size_t widest_line = 110;

// The visible stretch of a line and the caret's column in it.
struct Excerpt {
  std::string line;
  std::size_t caret = 0;
  std::size_t width = 1;
};

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// Bytes a terminal should not see become '?'; a tab becomes one space so that the caret stays below.
std::string printable(std::string_view line) {
  std::string result;
  result.reserve(line.size());
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\t') {
      result += ' ';
    } else {
      result += (byte < 0x20U || byte == 0x7FU) ? '?' : c;
    }
  }
  return result;
}

Excerpt excerpt(const Place& place) {
  const std::string_view line = line_of(place);
  const char* const begin = place.source->content.data();
  const std::size_t start = static_cast<std::size_t>(line.data() - begin);
  const std::size_t at =
      std::min<std::size_t>(place.offset - std::min<std::size_t>(place.offset, start), line.size());
  const std::size_t span = std::max<std::size_t>(1, std::min<std::size_t>(place.length, line.size() - at));

  std::size_t first = 0;
  std::size_t last = line.size();
  std::string_view before;
  std::string_view after;
  if (line.size() > widest_line) {
    first = at > widest_line / 2 ? at - widest_line / 2 : 0;
    last = std::min(line.size(), first + widest_line);
    while (first < at && is_continuation(line[first])) ++first;
    while (last < line.size() && is_continuation(line[last])) ++last;
    before = first > 0 ? "... " : "";
    after = last < line.size() ? " ..." : "";
  }
  Excerpt result;
  result.line = fmt::format("{}{}{}", before, printable(line.substr(first, last - first)), after);
  const auto characters = [&](std::size_t from, std::size_t to) {
    return static_cast<std::size_t>(std::count_if(line.begin() + static_cast<std::ptrdiff_t>(from),
                                                  line.begin() + static_cast<std::ptrdiff_t>(to),
                                                  [](char c) { return !is_continuation(c); }));
  };
  result.caret = before.size() + characters(first, at);
  result.width = std::max<std::size_t>(1, characters(at, std::min(at + span, last)));
  return result;
}

std::string with_place(const Place& place, std::string_view what) {
  if (!place.known()) return fmt::format("{}\n", what);
  const LineColumn position = line_and_column(place);
  const Excerpt shown = excerpt(place);
  return fmt::format("{}:{}:{}: {}\n  {}\n  {}^{}\n", place.source->name, position.line, position.column,
                     what, shown.line, std::string(shown.caret, ' '), std::string(shown.width - 1, '~'));
}

}  // namespace

std::string render(const Diagnostic& diagnostic) {
  const std::string_view kind = diagnostic.severity == Severity::error ? "error" : "warning";
  std::string result = with_place(diagnostic.place, fmt::format("{}: {}", kind, diagnostic.message));
  if (!diagnostic.hint.empty()) result += fmt::format("  {}\n", diagnostic.hint);
  for (const Note& note : diagnostic.notes)
    result += with_place(note.place, fmt::format("note: {}", note.message));
  return result;
}

std::string render(const std::vector<Diagnostic>& diagnostics) {
  std::string result;
  for (const Diagnostic& diagnostic : diagnostics) result += render(diagnostic);
  return result;
}

Error::Error(std::string message, std::string hint) : Error(Place{}, std::move(message), std::move(hint)) {}

Error::Error(Place place, std::string message, std::string hint)
    : Error(Diagnostic{Severity::error, std::move(place), std::move(message), std::move(hint), {}}) {}

Error::Error(Diagnostic diagnostic) : Error(std::vector<Diagnostic>{std::move(diagnostic)}) {}

Error::Error(std::vector<Diagnostic> diagnostics)
    : diagnostics_(std::move(diagnostics)), rendered_(render(diagnostics_)) {}

Error Error::placed_at(const Place& place) const {
  std::vector<Diagnostic> placed = diagnostics_;
  for (Diagnostic& diagnostic : placed) {
    if (!diagnostic.place.known()) diagnostic.place = place;
  }
  return Error(std::move(placed));
}

}  // namespace lamella::text
