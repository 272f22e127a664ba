#include "datafile/expectation.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "text/suggest.h"

namespace lamella::test {

namespace {

namespace files = std::filesystem;

std::vector<std::string> split_phrases(const std::string& rest) {
  std::vector<std::string> phrases;
  std::size_t begin = 0;
  while (begin <= rest.size()) {
    const std::size_t bar = std::min(rest.find(" | ", begin), rest.size());
    const std::size_t first = rest.find_first_not_of(' ', begin);
    if (first != std::string::npos && first < bar) phrases.push_back(rest.substr(first, bar - first));
    begin = bar + 3;
  }
  return phrases;
}

ExpectedMessage parse_message(std::istringstream& line, text::Severity severity) {
  ExpectedMessage message;
  message.severity = severity;
  std::string place;
  line >> place;
  const std::size_t column = place.rfind(':');
  const std::size_t row = place.rfind(':', column - 1);
  message.column = std::stoi(place.substr(column + 1));
  const std::size_t digits = row == std::string::npos ? 0 : row + 1;
  message.line = std::stoi(place.substr(digits, column - digits));
  if (row != std::string::npos) message.file = place.substr(0, row);
  std::string rest;
  std::getline(line, rest);
  message.phrases = split_phrases(rest);
  return message;
}

bool says(const text::Diagnostic& diagnostic, const std::string& phrase) {
  return text::lower(diagnostic.message + "\n" + diagnostic.hint).find(phrase) != std::string::npos;
}

bool fits(const ExpectedMessage& expected, const text::Diagnostic& found, const std::string& datafile) {
  if (expected.severity != found.severity || !found.place.known()) return false;
  const text::LineColumn at = text::line_and_column(found.place);
  const std::string file = files::path(found.place.source->name).filename();
  const std::string wanted =
      expected.file.empty() ? files::path(datafile).filename().string() : expected.file;
  return file == wanted && at.line == expected.line && at.column == expected.column &&
         std::all_of(expected.phrases.begin(), expected.phrases.end(),
                     [&](const std::string& phrase) { return says(found, phrase); });
}

std::string describe(const ExpectedMessage& message) {
  std::string result =
      fmt::format("{} {}{}:{}", message.severity == text::Severity::error ? "error" : "warning",
                  message.file.empty() ? "" : message.file + ":", message.line, message.column);
  for (const std::string& phrase : message.phrases) result += fmt::format(" | {}", phrase);
  return result;
}

}  // namespace

Expectation read_expectation(const std::string& path) {
  Expectation result;
  std::ifstream file(path);
  std::string text;
  while (std::getline(file, text)) {
    std::istringstream line(text);
    std::string word;
    line >> word;
    if (word == "status") {
      line >> result.status;
    } else if (word == "error") {
      result.messages.push_back(parse_message(line, text::Severity::error));
    } else if (word == "warning") {
      result.messages.push_back(parse_message(line, text::Severity::warning));
    } else if (word == "counts") {
      for (std::uint32_t count = 0; line >> count;) result.counts.push_back(count);
    } else if (word == "area") {
      line >> result.area.emplace();
    }
  }
  return result;
}

std::string difference(const std::vector<ExpectedMessage>& expected,
                       const std::vector<text::Diagnostic>& found, const std::string& datafile) {
  std::vector<text::Diagnostic> placed = found;
  if (!placed.empty() && !placed.back().place.known()) placed.pop_back();
  bool same = expected.size() == placed.size();
  for (std::size_t i = 0; same && i < expected.size(); ++i) same = fits(expected[i], placed[i], datafile);
  if (same) return {};
  std::string result = "expected\n";
  for (const ExpectedMessage& message : expected) result += fmt::format("  {}\n", describe(message));
  return result + "found\n" + text::render(found);
}

std::vector<std::string> datafiles_in(const std::string& folder) {
  std::vector<std::string> result;
  for (const auto& entry : files::directory_iterator(files::path(LAMELLA_SOURCE_DIR) / folder)) {
    if (entry.path().extension() == ".fe") result.push_back(entry.path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace lamella::test
