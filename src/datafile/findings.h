// What is wrong with a datafile: all of it, in the order of its text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "text/error.h"

namespace lamella::datafile {

class Findings {
 public:
  void error(text::Place place, std::string message, std::string hint = {},
             std::vector<text::Note> notes = {});
  void warning(text::Place place, std::string message, std::string hint = {},
               std::vector<text::Note> notes = {});
  void take(const text::Error& error);

  bool has_errors() const { return errors_ > 0; }
  // A file of rubbish is not read to its end.
  bool too_many() const { return errors_ >= most_kept; }

  // In the order of their places; sources in the order in which `sources` were opened. After twenty, one line
  // says how many more there are.
  std::vector<text::Diagnostic> in_order(const std::vector<text::SourcePointer>& sources) const;

 private:
  static constexpr std::size_t most_kept = 200;
  static constexpr std::size_t most_shown = 20;

  void add(text::Diagnostic diagnostic);

  std::vector<text::Diagnostic> diagnostics_;
  std::size_t errors_ = 0;
};

}  // namespace lamella::datafile
