#include "datafile/top_values.h"

#include <cmath>

#include "datafile/top_section.h"
#include "language/expression_parser.h"
#include "language/formula_scope.h"

namespace lamella::datafile {

using language::Token;
using language::TokenKind;

namespace {

language::Value value_of_expression(Reading& reading, language::ExpressionStyle style) {
  language::ConstantScope scope(reading.scene.variables);
  language::ExpressionParser parser(reading.tokens, scope, style);
  const language::ExpressionPointer expression = parser.expression();
  language::Value value = language::evaluate_constant_value(*expression, reading.scene.variables);
  const double* const number = std::get_if<double>(&value);
  if (number != nullptr && !std::isfinite(*number)) {
    throw text::Error(expression->place, "this is not a finite number");
  }
  return value;
}

}  // namespace

bool top_value_follows(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  std::size_t ahead = 0;
  while (tokens.peek(ahead).is(TokenKind::newline)) ++ahead;
  const Token& token = tokens.peek(ahead);
  const bool sign =
      token.is_symbol("-") || token.is_symbol("+") || token.is_symbol("(") || token.is_symbol("!");
  const bool word = token.is(TokenKind::word) && !begins_declaration(token.text);
  if (!token.is(TokenKind::number) && !sign && !word) return false;
  for (; ahead > 0; --ahead) tokens.take();
  return true;
}

double top_value(Reading& reading, const std::string& missing) {
  const text::Place here = reading.tokens.peek().place;
  if (!top_value_follows(reading)) throw text::Error(here, missing);
  const text::Place place = reading.tokens.peek().place;
  const language::Value value = value_of_expression(reading, language::ExpressionStyle::values);
  if (const double* const number = std::get_if<double>(&value)) return *number;
  throw text::Error(place, missing);
}

language::Formula top_value_of_variables(Reading& reading, const std::string& missing) {
  const text::Place here = reading.tokens.peek().place;
  if (!top_value_follows(reading)) throw text::Error(here, missing);
  return language::parse_formula(reading.tokens, language::FormulaKind::variables, reading.scene.variables,
                                 {}, language::ExpressionStyle::values);
}

language::Value top_formula(Reading& reading) {
  return value_of_expression(reading, language::ExpressionStyle::formula);
}

}  // namespace lamella::datafile
