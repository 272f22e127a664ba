// The words of a datafile or of typed commands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "text/source.h"

namespace lamella::language {

enum class TokenKind : std::uint8_t { end, newline, number, word, string, symbol };

struct Token {
  TokenKind kind = TokenKind::end;
  bool space_before = false;  // white space or a comment stands before it (not: a line end)
  char separator = 0;         // datafiles: the last ',' ':' or ';' in the space before it, 0 for none
  std::string_view text;      // as written; a view into the source, which `place` keeps alive
  double number = 0;          // of a number
  std::string content;        // of a string, without quotes and escapes
  text::Place place;

  bool is(TokenKind k) const { return kind == k; }
  bool is_symbol(std::string_view symbol) const { return kind == TokenKind::symbol && text == symbol; }
  // Upper and lower case are the same; `word` must be given in lower case.
  bool is_word(std::string_view word) const;
  bool ends_line() const { return kind == TokenKind::end || kind == TokenKind::newline; }
};

// A token as messages name it: `"foo"`, `the end of the line`.
std::string describe(const Token& token);

// Where parsers take tokens from: a lexer, or something that replaces tokens on the way (macros).
class TokenStream {
 public:
  virtual ~TokenStream() = default;
  // The token `ahead` places after the next one, without taking it. References hold until the next call.
  virtual const Token& peek(std::size_t ahead = 0) = 0;
  virtual Token take() = 0;
  // Between brackets, a stream of commands passes over line ends.
  virtual void enter_brackets() {}
  virtual void leave_brackets() {}
};

// Brackets opened for the life of this object.
class Brackets {
 public:
  explicit Brackets(TokenStream& tokens) : tokens_(tokens) { tokens_.enter_brackets(); }
  Brackets(const Brackets&) = delete;
  Brackets& operator=(const Brackets&) = delete;
  ~Brackets() { tokens_.leave_brackets(); }

 private:
  TokenStream& tokens_;
};

// The text from the beginning of one place to the end of another in the same source.
text::Place join(const text::Place& first, const text::Place& last);

}  // namespace lamella::language
