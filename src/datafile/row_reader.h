// Reads the lines of an element list: first the plain numbers straight from the bytes, then whatever follows
// as tokens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "datafile/rows.h"
#include "datafile/token_source.h"
#include "language/scope.h"

namespace lamella::datafile {

class RowReader {
 public:
  RowReader(TokenSource& tokens, const language::Variables& variables)
      : tokens_(tokens), variables_(variables), scope_(variables) {}

  // Looks at the next line that is not blank.
  void begin_line();
  // Passes over what is left of the line.
  void skip_line();

  bool at_line_end();
  bool at_file_end();
  // Whether a value begins here that does not begin with a word.
  bool at_number();
  // Whether a whole number begins here.
  bool at_whole();
  bool at_word();

  // An expression without unknowns. Throws text::Error: what is wrong with it, a value that is not finite.
  GivenValue value();
  // A whole number such as -12, written out.
  GivenValue whole();
  const language::Token& peek() { return tokens_.peek(); }  // where no plain number is left
  language::Token word() { return tokens_.take(); }
  bool accept(std::string_view symbol);
  // To be called after a brace has opened: numbers in it are read straight from the bytes.
  void begin_braces();

  // The place of what stands next, or of the line's end, and how messages name it.
  Spot here();
  std::string describe_next();
  text::Place place(Spot spot) const { return tokens_.place(spot); }
  TokenSource& tokens() { return tokens_; }

 private:
  bool plain_left() const { return next_plain_ < plain_.values.size(); }
  GivenValue plain();
  void refuse_not_finite();

  TokenSource& tokens_;
  const language::Variables& variables_;
  language::ConstantScope scope_;
  PlainRow plain_;
  std::size_t next_plain_ = 0;
};

}  // namespace lamella::datafile
