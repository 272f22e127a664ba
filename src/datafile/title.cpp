#include "datafile/title.h"

#include <algorithm>

#include <fmt/format.h>

namespace lamella::datafile {

namespace {

constexpr std::string_view blanks = " \t\r\f";

std::string_view trimmed_end(std::string_view line) {
  // A backslash at the end would carry the comment on.
  const std::size_t last = line.find_last_not_of(" \t\r\f\\");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

std::string_view without_indent(std::string_view line) {
  return line.substr(std::min(line.find_first_not_of(blanks), line.size()));
}

std::string_view take_line(std::string_view& content) {
  const std::size_t end = std::min(content.find_first_of("\n\r"), content.size());
  const std::string_view line = content.substr(0, end);
  content.remove_prefix(
      std::min(content.size(), content.substr(end).starts_with("\r\n") ? end + 2 : end + 1));
  return line;
}

}  // namespace

std::string title_of(std::string_view content) {
  std::string title;
  bool in_block = false;
  while (!content.empty()) {
    std::string_view line = take_line(content);
    bool closes = false;
    if (!in_block) {
      const std::string_view text = without_indent(line);
      if (text.empty() && title.empty()) continue;
      in_block = text.starts_with("/*");
      if (!in_block && !text.starts_with("//")) break;
      line = text.substr(2);
    }
    if (in_block) {
      const std::size_t close = line.find("*/");
      closes = close != std::string_view::npos;
      if (closes && !without_indent(line.substr(close + 2)).empty())
        break;  // the comment is not alone on its line
      line = line.substr(0, std::min(close, line.size()));
    }
    if (line.starts_with(' ')) line.remove_prefix(1);
    title += fmt::format("{}{}", title.empty() ? "" : "\n", trimmed_end(line));
    in_block = in_block && !closes;
  }
  while (title.ends_with('\n')) title.pop_back();
  return title;
}

std::string title_comment(std::string_view title) {
  std::string comment;
  while (!title.empty()) {
    const std::string_view line = take_line(title);
    comment += fmt::format("//{}{}\n", line.empty() ? "" : " ", line);
  }
  return comment;
}

}  // namespace lamella::datafile
