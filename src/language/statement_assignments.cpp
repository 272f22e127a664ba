// Assignments, as StatementParser takes them.
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "language/functions.h"
#include "language/statement_parser.h"

namespace lamella::language {

namespace {

std::optional<AssignmentKind> assignment_kind(const Token& token) {
  constexpr std::array<std::pair<std::string_view, AssignmentKind>, 7> symbols = {
      {{":=", AssignmentKind::set},
       {"::=", AssignmentKind::set},
       {":::=", AssignmentKind::set},
       {"+=", AssignmentKind::add},
       {"-=", AssignmentKind::subtract},
       {"*=", AssignmentKind::multiply},
       {"/=", AssignmentKind::divide}}};
  for (const auto& [symbol, kind] : symbols) {
    if (token.is_symbol(symbol)) return kind;
  }
  return std::nullopt;
}

}  // namespace

StatementPointer StatementParser::assignment() {
  const Token name = tokens_.take();
  if (tokens_.peek().is_symbol("++") || tokens_.peek().is_symbol("--")) {
    return step(name, name.place, tokens_.take().text == "++");
  }
  const bool permanent = tokens_.peek().is_symbol("::=") || tokens_.peek().is_symbol(":::=");
  const bool plain = tokens_.peek().is_symbol(":=") || permanent;
  if (plain && scope_.locals().find(name.text) == nullptr) {
    const std::uint32_t mark = tokens_.mark();
    tokens_.take();
    const bool letter = permanent && name.text.size() == 1 && scope_.is_command(name.text);
    if (letter && (at_command_end(tokens_) || tokens_.peek().is_symbol("{"))) return letter_definition(name);
    skip_lines();
    const bool block = tokens_.peek().is_symbol("{") && !at_array_literal();
    if (block || value_is_command()) return procedure_definition(name);
    tokens_.rewind(mark);
  }
  return assign_name(name);
}

// Whether braces hold numbers: no command begins with one.
bool StatementParser::at_array_literal() {
  std::size_t ahead = 0;
  while (tokens_.peek(ahead).is_symbol("{")) ++ahead;
  const Token& first = tokens_.peek(ahead);
  return ahead > 0 && (first.is(TokenKind::number) || first.is_symbol("-") || first.is_symbol("("));
}

// `set background white` is background := white.
bool StatementParser::at_named_setting() {
  const Token& name = tokens_.peek(1);
  return tokens_.peek().is_word("set") && name.is(TokenKind::word) && !element_kind(name.text) &&
         (scope_.variable(name.text) || scope_.internal(name.text));
}

StatementPointer StatementParser::named_setting() {
  const text::Place place = tokens_.take().place;
  const Token name = tokens_.take();
  Assignment result;
  if (tokens_.peek().is_symbol(":=")) tokens_.take();
  result.value = expression();
  if (const auto variable = scope_.variable(name.text)) {
    result.target = *variable;
  } else {
    result.target = *scope_.internal(name.text);
  }
  return make_statement(std::move(result), place);
}

// Whether what follows `name :=` is a command, as in `gg := g 10`: its word means no value, or is given one
// as in `few := transforms off`.
bool StatementParser::value_is_command() {
  const Token& token = tokens_.peek();
  if (!token.is(TokenKind::word) || !scope_.is_command(token.text)) return false;
  const std::string_view after = tokens_.text_after_next();
  const auto follows = [&](std::string_view word) {
    const std::string_view rest = after.substr(std::min(word.size(), after.size()));
    return after.starts_with(word) &&
           (rest.empty() || std::isalnum(static_cast<unsigned char>(rest[0])) == 0);
  };
  if (after.starts_with("\"") || follows("on") || follows("off")) return true;
  const bool value = scope_.variable(token.text) || scope_.internal(token.text) ||
                     scope_.locals().find(token.text) != nullptr || named_number(token.text);
  return !value && !tokens_.text_after_next().starts_with("(");
}

void StatementParser::check_new_name(const Token& name) {
  if (is_keyword(name.text) || element_kind(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is a word of the language", name.text),
                      "choose another name");
  }
}

StatementPointer StatementParser::assign_name(const Token& name) {
  if (const Local* const local = scope_.locals().find(name.text)) {
    if (local->element)
      throw text::Error(name.place, fmt::format("\"{}\" is an element, which cannot be replaced", name.text));
    return assign_to(local->id);
  }
  if (const auto internal = scope_.internal(name.text); internal && !scope_.variable(name.text))
    return assign_to(*internal);
  check_new_name(name);
  if (scope_.procedure(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is a procedure", name.text),
                      "choose another name for the value");
  }
  const bool plain = *assignment_kind(tokens_.peek()) == AssignmentKind::set;
  if (!plain && !scope_.variable(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is not defined", name.text),
                      suggest_name(name.text, scope_));
  }
  // The value is parsed before the name exists: x := x + 1 needs an x from before.
  const text::Place place = tokens_.peek().place;
  Assignment result = assigned_value();
  result.target = scope_.promise_variable(name.text);
  return make_statement(std::move(result), place);
}

// `:= value` and the like, the target still open.
Assignment StatementParser::assigned_value() {
  Assignment result;
  result.permanent = tokens_.peek().text.starts_with("::");
  result.kind = *assignment_kind(tokens_.take());
  skip_lines();
  result.value = tokens_.peek().is_symbol("{") ? expressions().array_literal() : expression();
  return result;
}

StatementPointer StatementParser::assign_to(AssignmentTarget target) {
  const text::Place place = tokens_.peek().place;
  Assignment result = assigned_value();
  result.target = std::move(target);
  return make_statement(std::move(result), place);
}

// costs[2][3] := value
StatementPointer StatementParser::array_assignment() {
  const Token name = tokens_.take();
  ArrayUse target{*scope_.variable(name.text), {}};
  text::Place place = name.place;
  target.indices = expressions().array_indices(place);
  if (!assignment_kind(tokens_.peek())) unexpected("\":=\"");
  return assign_to(std::move(target));
}

// name++ or --name
StatementPointer StatementParser::step(const Token& name, const text::Place& place, bool up) {
  Assignment result;
  result.kind = up ? AssignmentKind::add : AssignmentKind::subtract;
  auto one = std::make_unique<Expression>();
  one->node = Number{1};
  one->place = place;
  result.value = std::move(one);
  if (const Local* const local = scope_.locals().find(name.text); local != nullptr && !local->element) {
    result.target = local->id;
  } else if (const auto variable = scope_.variable(name.text)) {
    result.target = *variable;
  } else if (const auto internal = scope_.internal(name.text)) {
    result.target = *internal;
  } else {
    throw text::Error(name.place, fmt::format("\"{}\" is not defined", name.text),
                      suggest_name(name.text, scope_));
  }
  return make_statement(std::move(result), place);
}

StatementPointer StatementParser::attribute_assignment() {
  ExpressionParser parser = expressions();
  text::Place dotted;
  if (const auto internal = parser.dotted_internal(dotted)) {
    if (!assignment_kind(tokens_.peek())) unexpected("\":=\"");
    return assign_to(*internal);
  }
  parser.refuse_unknown_part();
  const Token first = tokens_.peek();
  if (!(tokens_.peek(1).is_symbol("[") || tokens_.peek(1).is_symbol("."))) {
    throw text::Error(first.place, fmt::format("a command cannot begin with {}", describe(first)),
                      fmt::format("write list {0}, print {0}.id or {0}.x := 1", first.text));
  }
  ElementPath path = parser.element();
  expect(".", "and an attribute");
  AttributeUse target = parser.attribute(std::move(path));
  if (!assignment_kind(tokens_.peek())) unexpected("\":=\"");
  return assign_to(std::move(target));
}

}  // namespace lamella::language
