#include "exchange/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace lamella::exchange {

namespace {

constexpr std::string_view blanks = " \t\f\v";

std::string_view without_plus(std::string_view word) {
  return word.starts_with('+') ? word.substr(1) : word;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

WordReader::WordReader(std::string name, std::string content, char comment)
    : source_(text::make_source(std::move(name), std::move(content))), comment_(comment) {}

bool WordReader::next_line() {
  const std::string_view all = source_->content;
  words_.clear();
  while (words_.empty() && at_ < all.size()) {
    const std::size_t end = std::min(all.find_first_of("\r\n", at_), all.size());
    std::string_view line = all.substr(at_, end - at_);
    line = line.substr(0, line.find(comment_));
    line_end_ = end;
    at_ = all.substr(end).starts_with("\r\n") ? end + 2 : end + 1;
    for (std::size_t i = line.find_first_not_of(blanks); i != std::string_view::npos;) {
      const std::size_t stop = std::min(line.find_first_of(blanks, i), line.size());
      words_.push_back(line.substr(i, stop - i));
      i = line.find_first_not_of(blanks, stop);
    }
  }
  at_ = std::min(at_, all.size());
  return !words_.empty();
}

text::Place WordReader::place(std::size_t i) const {
  if (i >= words_.size()) return {source_, static_cast<std::uint32_t>(line_end_), 0};
  const auto offset = static_cast<std::uint32_t>(words_[i].data() - source_->content.data());
  return {source_, offset, static_cast<std::uint32_t>(words_[i].size())};
}

void WordReader::fail(std::size_t i, std::string message, std::string hint) const {
  throw text::Error(place(i), std::move(message), std::move(hint));
}

void WordReader::fail_at_end(std::string message) const {
  throw text::Error(text::Place{source_, static_cast<std::uint32_t>(source_->content.size()), 0},
                    std::move(message));
}

double WordReader::number(std::size_t i, std::string_view what) const {
  if (i >= words_.size()) fail(i, fmt::format("the line ends before {}", what));
  const std::optional<double> value = number_of(words_[i]);
  if (!value) fail(i, fmt::format("{} is a number, not \"{}\"", what, words_[i]));
  return *value;
}

long WordReader::whole(std::size_t i, std::string_view what) const {
  if (i >= words_.size()) fail(i, fmt::format("the line ends before {}", what));
  const std::string_view word = without_plus(words_[i]);
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail(i, fmt::format("{} is a whole number, not \"{}\"", what, words_[i]));
  return value;
}

}  // namespace lamella::exchange
