#include "datafile/row_reader.h"

#include <cmath>

#include <fmt/format.h>

#include "language/evaluate.h"
#include "language/expression_parser.h"

namespace lamella::datafile {

using language::Token;
using language::TokenKind;

void RowReader::begin_line() {
  next_plain_ = 0;
  tokens_.take_plain_row(plain_);
  if (!plain_.values.empty() || plain_.complete) return;
  while (tokens_.peek().is(TokenKind::newline)) {
    tokens_.take();
    tokens_.take_plain_row(plain_);
    if (!plain_.values.empty() || plain_.complete) return;
  }
}

void RowReader::skip_line() {
  next_plain_ = plain_.values.size();
  if (!plain_.complete) tokens_.skip_line();
}

bool RowReader::at_line_end() {
  return !plain_left() && (plain_.complete || tokens_.peek().ends_line());
}

bool RowReader::at_file_end() {
  return !plain_left() && !plain_.complete && tokens_.peek().is(TokenKind::end);
}

bool RowReader::at_number() {
  if (plain_left()) return true;
  if (plain_.complete) return false;
  const Token& token = tokens_.peek();
  const bool sign =
      token.is_symbol("-") || token.is_symbol("+") || token.is_symbol("(") || token.is_symbol("!");
  return sign || token.is(TokenKind::number);
}

bool RowReader::at_whole() {
  if (plain_left()) return true;
  if (plain_.complete) return false;
  const Token& token = tokens_.peek();
  return token.is(TokenKind::number) || (token.is_symbol("-") && tokens_.peek(1).is(TokenKind::number));
}

bool RowReader::at_word() {
  return !plain_left() && !plain_.complete && tokens_.peek().is(TokenKind::word);
}

GivenValue RowReader::plain() {
  const std::size_t i = next_plain_++;
  return {plain_.values[i], plain_.spots[i]};
}

// Written by programs that did not look at what they computed.
void RowReader::refuse_not_finite() {
  const bool sign = tokens_.peek().is_symbol("-") || tokens_.peek().is_symbol("+");
  const text::Place begin = tokens_.peek().place;
  const Token& word = tokens_.peek(sign ? 1 : 0);
  if (!word.is_word("nan") && !word.is_word("inf") && !word.is_word("infinity")) return;
  throw text::Error(language::join(begin, word.place),
                    fmt::format("{} is not a finite number", describe(word)));
}

GivenValue RowReader::value() {
  if (plain_left()) return plain();
  refuse_not_finite();
  language::ExpressionParser parser(tokens_, scope_, language::ExpressionStyle::values);
  const language::ExpressionPointer expression = parser.expression();
  const double value = language::evaluate_constant(*expression, variables_);
  if (!std::isfinite(value)) throw text::Error(expression->place, "this is not a finite number");
  return {value, tokens_.spot(expression->place)};
}

GivenValue RowReader::whole() {
  GivenValue result;
  if (plain_left()) {
    result = plain();
  } else {
    const Token first = tokens_.take();
    const bool negative = first.is_symbol("-");
    const Token number = negative ? tokens_.take() : first;
    if (!number.is(TokenKind::number)) {
      throw text::Error(number.place,
                        fmt::format("expected a whole number, found {}", language::describe(number)));
    }
    result = {negative ? -number.number : number.number,
              tokens_.spot(language::join(first.place, number.place))};
  }
  if (result.value != std::floor(result.value)) {
    throw text::Error(place(result.spot), fmt::format("a whole number is needed here, not {}", result.value));
  }
  return result;
}

void RowReader::begin_braces() {
  next_plain_ = 0;
  tokens_.take_plain_values(plain_);
}

bool RowReader::accept(std::string_view symbol) {
  if (plain_left() || plain_.complete || !tokens_.peek().is_symbol(symbol)) return false;
  tokens_.take();
  return true;
}

Spot RowReader::here() {
  if (plain_left()) return plain_.spots[next_plain_];
  if (plain_.complete) return plain_.end;
  return tokens_.spot(tokens_.peek().place);
}

std::string RowReader::describe_next() {
  if (plain_left()) return fmt::format("{}", plain_.values[next_plain_]);
  if (plain_.complete) return "the end of the line";
  return describe(tokens_.peek());
}

}  // namespace lamella::datafile
