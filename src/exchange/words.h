// Text files of words and numbers, line by line, with the place of each word.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/error.h"

namespace lamella::exchange {

class WordReader {
 public:
  // From `comment` on a line is passed over.
  WordReader(std::string name, std::string content, char comment);

  // The words of the next line that has any; false at the end.
  bool next_line();
  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t count() const { return words_.size(); }
  std::string_view word(std::size_t i) const { return words_[i]; }

  // The i-th word of the line as a number. Throws text::Error where there is none.
  double number(std::size_t i, std::string_view what) const;
  long whole(std::size_t i, std::string_view what) const;

  // Of the i-th word; of the line's end where it has fewer.
  text::Place place(std::size_t i) const;
  [[noreturn]] void fail(std::size_t i, std::string message, std::string hint = {}) const;
  // Where the file ends too early.
  [[noreturn]] void fail_at_end(std::string message) const;

  // What follows the present line.
  std::string_view rest() const { return std::string_view(source_->content).substr(at_); }
  void rewind() { at_ = 0; }

 private:
  text::SourcePointer source_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t line_end_ = 0;
  std::vector<std::string_view> words_;
};

// The whole word as a finite number; nothing where it is none.
std::optional<double> number_of(std::string_view word);

}  // namespace lamella::exchange
