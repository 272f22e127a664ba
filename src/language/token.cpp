#include "language/token.h"

#include <algorithm>

#include <fmt/format.h>

namespace lamella::language {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

bool Token::is_word(std::string_view word) const {
  return kind == TokenKind::word && text.size() == word.size() &&
         std::equal(text.begin(), text.end(), word.begin(), [](char a, char b) { return lower(a) == b; });
}

std::string describe(const Token& token) {
  constexpr std::size_t longest = 40;
  switch (token.kind) {
    case TokenKind::end:
      return "the end of the text";
    case TokenKind::newline:
      return "the end of the line";
    default:
      break;
  }
  if (token.text.size() > longest) return fmt::format("\"{}...\"", token.text.substr(0, longest));
  return token.is(TokenKind::string) ? std::string(token.text) : fmt::format("\"{}\"", token.text);
}

text::Place join(const text::Place& first, const text::Place& last) {
  text::Place result = first;
  if (first.source == last.source && last.offset >= first.offset) {
    result.length = last.offset + last.length - first.offset;
  }
  return result;
}

}  // namespace lamella::language
