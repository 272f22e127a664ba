// Cuts text into tokens.
//
// Both modes: `\` at a line's end continues it, `//` runs to the line's end, `/* */` is a space, line ends
// are LF, CR LF or CR, a byte-order mark at the start and Ctrl-Z are passed over. Numbers: 2 .5 23. 5e-10
// 0.7D2 0x12Af 11001b; signs are operators. Strings: "..." with the escapes \n \t \r \b \q, and \c for the
// character c elsewise.
#pragma once

#include <deque>

#include "language/token.h"
#include "text/error.h"

namespace lamella::language {

enum class LexerMode : std::uint8_t {
  datafile,  // commas, colons and semicolons are white space (Token::separator tells), '#' is a symbol,
             // strings end on their line
  command,   // commas, colons and semicolons are symbols, and there are := += >> and the like; strings may
             // span lines
};

// What is missing may still be typed: an open comment, string, brace or expression at the end of the text.
class Incomplete : public text::Error {
 public:
  using text::Error::Error;
};

class Lexer {
 public:
  // Throws where the text is not text at all (UTF-16, more than 4 GB).
  Lexer(text::SourcePointer source, LexerMode mode);
  // Only the bytes of `part`, such as the commands at the end of a datafile.
  Lexer(const text::Place& part, LexerMode mode);

  // The next token; `end` again and again at the end. Throws text::Error with the place of what cannot be a
  // token (an unexpected character, a malformed number, an open comment); the lexer then stands behind it.
  Token next();

  std::uint32_t offset() const { return at_; }
  // Goes on from another byte.
  void seek(std::uint32_t offset) { at_ = offset; }
  const text::SourcePointer& source() const { return source_; }
  std::uint32_t end() const { return end_; }
  LexerMode mode() const { return mode_; }

 private:
  struct Space {
    bool any = false;
    char separator = 0;
  };
  char byte(std::uint32_t offset) const { return offset < end_ ? content_[offset] : '\0'; }
  std::uint32_t line_end_length(std::uint32_t offset) const;
  Space skip_space();
  bool skip_comment();
  Token token(TokenKind kind, std::uint32_t begin) const;
  text::Place place(std::uint32_t begin, std::uint32_t length) const { return {source_, begin, length}; }
  Token number();
  Token string();
  Token quoted_letter();
  Token symbol();
  [[noreturn]] void refuse_byte();

  text::SourcePointer source_;
  std::string_view content_;
  std::uint32_t at_ = 0;
  std::uint32_t end_ = 0;
  LexerMode mode_;
};

// A lexer's tokens as a stream.
class LexerStream : public TokenStream {
 public:
  explicit LexerStream(Lexer lexer) : lexer_(std::move(lexer)), previous_end_(lexer_.offset()) {}

  const Token& peek(std::size_t ahead = 0) override;
  Token take() override;
  void enter_brackets() override { ++brackets_; }
  void leave_brackets() override { --brackets_; }

  // The byte where the next token begins, and the way back to it.
  std::uint32_t mark() { return peek().place.offset; }
  void rewind(std::uint32_t mark);
  // The byte behind the token taken last.
  std::uint32_t previous_end() const { return previous_end_; }

  // --- what comes next, not cut into tokens: a file's name without quotes need not be made of any
  // The text from the next byte that is no blank, and that behind the next token.
  std::string_view text_ahead() const { return text_from(previous_end_); }
  std::string_view text_after_next();
  // The next run of bytes up to white space, `;`, a comma, a bracket, a quote or a line's end; empty at a
  // comment or a redirection.
  std::string_view bare_word_ahead() const;
  // Takes it as a word.
  Token take_bare_word();

 private:
  std::string_view text_from(std::uint32_t offset) const;

  Lexer lexer_;
  std::deque<Token> ahead_;
  std::uint32_t previous_end_ = 0;
  int brackets_ = 0;
};

}  // namespace lamella::language
