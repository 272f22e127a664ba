#include "datafile/definitions.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/force_settings.h"
#include "datafile/settings.h"
#include "datafile/top_section.h"
#include "datafile/top_values.h"
#include "language/elements.h"
#include "language/functions.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using language::Token;
using language::TokenKind;

constexpr std::size_t most_dimensions = 8;
constexpr double largest_width = 10000;

// A single letter may stand for anything, even where it is a number of its own (e).
bool is_taken(std::string_view name) {
  if (name.size() == 1) return false;
  return begins_declaration(name) || is_attribute_word(name) || language::element_kind(name).has_value() ||
         language::find_function(name) != nullptr || language::named_number(name).has_value();
}

Token take_new_name(Reading& reading, std::string_view what) {
  Token name = reading.tokens.peek();
  if (!name.is(TokenKind::word)) throw text::Error(name.place, fmt::format("{} needs a name", what));
  if (is_taken(name.text)) {
    throw text::Error(name.place,
                      fmt::format("{} needs a name, and \"{}\" is a word of the language", what, name.text),
                      "choose another name");
  }
  reading.tokens.take();
  return name;
}

void set_variable(Reading& reading, const Token& name, language::Value value, bool parameter) {
  const SettingParameter* const setting = find_setting_parameter(name.text);
  const double* const number = std::get_if<double>(&value);
  if (setting != nullptr && number != nullptr) {
    setting->set(reading.scene, *number);
    return;
  }
  const std::string* const text = std::get_if<std::string>(&value);
  if (text != nullptr && read_force_setting(reading, name, *text)) return;
  language::Variables& variables = reading.scene.variables;
  const auto [first, is_new] = reading.defined.try_emplace(text::lower(name.text), name.place);
  if (!is_new) {
    throw text::Error({text::Severity::error,
                       name.place,
                       fmt::format("\"{}\" is defined already, on line {}", name.text,
                                   text::line_and_column(first->second).line),
                       {},
                       {{first->second, "first defined here"}}});
  }
  const language::VariableId id = variables.id(name.text);
  variables.set(id, std::move(value));
  if (parameter) variables.mark_parameter(id);
}

// `:=` comes as a '=' with a colon before it. It may stand on the next line.
bool take_equals(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  std::size_t ahead = 0;
  while (tokens.peek(ahead).is(TokenKind::newline)) ++ahead;
  if (!tokens.peek(ahead).is_symbol("=")) return false;
  for (++ahead; ahead > 0; --ahead) tokens.take();
  return true;
}

// A number above 0.
double read_weight(Reading& reading, const Token& word) {
  reading.tokens.take();
  take_equals(reading);
  const text::Place place = reading.tokens.peek().place;
  const double value = top_value(reading, fmt::format("\"{}\" needs a number", word.text));
  if (!(value > 0)) throw text::Error(place, fmt::format("\"{}\" must be above 0", word.text));
  return value;
}

// What may follow the value: steps and weights, for when the parameter is optimized. Returns whether there
// were any.
bool read_parameter_options(Reading& reading, scene::FreeParameter& parameter) {
  TokenSource& tokens = reading.tokens;
  bool any = false;
  while (true) {
    const Token word = tokens.peek();
    const bool short_name = tokens.peek(1).is_symbol("=");
    if (word.is_word("pdelta") || (word.is_word("delta") && short_name)) {
      parameter.delta = read_weight(reading, word);
      any = true;
    } else if (word.is_word("pscale") || (word.is_word("scale") && short_name)) {
      parameter.scale = read_weight(reading, word);
      any = true;
    } else if (word.is_word("on_assign_call")) {
      reading.refuse(word.place, "on_assign_call", "procedures that run when a parameter changes");
      tokens.skip_line();
    } else {
      return any;
    }
  }
}

// --- define

std::vector<int> read_shape(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  std::vector<int> shape;
  double width = 1;
  while (tokens.peek().is_symbol("[")) {
    const Token opener = tokens.take();
    const double size = top_value(reading, "the number of values is missing between the brackets");
    width *= size;
    if (size < 1 || size != std::floor(size) || width > largest_width || shape.size() == most_dimensions) {
      throw text::Error(opener.place,
                        "an attribute has at most eight dimensions, each a whole number from 1, and at "
                        "most 10000 values");
    }
    if (!tokens.peek().is_symbol("]"))
      throw text::Error(opener.place, "this \"[\" is never closed: missing \"]\"");
    tokens.take();
    shape.push_back(static_cast<int>(size));
  }
  return shape;
}

// What the program keeps under a name of its own must have the right shape.
void check_carried(film::ElementKind kind, const Token& name, bool integer, const std::vector<int>& shape) {
  const std::string key = text::lower(name.text);
  const CarriedColumn* const carried = carried_column(kind, key);
  const bool is_ramp = kind == film::ElementKind::body && key == ramp_name;
  if (carried == nullptr && !is_ramp) return;
  const int width = is_ramp ? ramp_width : carried->width;
  if (!integer && shape == (width == 1 ? std::vector<int>{} : std::vector{width})) return;
  const bool earlier = carried != nullptr && carried->least > 0;
  if (!integer && earlier && shape.size() == 1 && shape[0] >= carried->least && shape[0] < width) return;
  const std::string wanted = width == 1 ? "real" : fmt::format("real[{}]", width);
  throw text::Error(name.place, fmt::format("the {} of {} is kept as {}", key, element_plural(kind), wanted));
}

void read_attribute(Reading& reading, film::ElementKind kind) {
  TokenSource& tokens = reading.tokens;
  const Token name = tokens.peek();
  const bool named = name.is(TokenKind::word) && !name.is_word("real") && !name.is_word("integer");
  if (!named) {
    throw text::Error(name.place, "an attribute needs a name",
                      fmt::format("write define {} attribute NAME real", film::name_of(kind)));
  }
  take_new_name(reading, "an attribute");
  const Token type = tokens.take();
  const bool integer = type.is_word("integer") || type.is_word("uint") || type.is_word("ulong");
  if (!integer && !type.is_word("real")) {
    throw text::Error(
        type.place, fmt::format("expected the kind of number of \"{}\", found {}", name.text, describe(type)),
        "write real or integer");
  }
  std::vector<int> shape = read_shape(reading);
  check_carried(kind, name, integer, shape);
  if (tokens.peek().is_word("function")) {
    reading.refuse(tokens.peek().place, "function", "attributes by formula");
    tokens.skip_line();
  }
  std::vector<film::Column>& columns = reading.rows.columns_of(kind);
  const std::string key = text::lower(name.text);
  const bool again =
      std::any_of(columns.begin(), columns.end(), [&](const auto& column) { return column.name == key; });
  if (!again) columns.push_back(declared_column(kind, key, integer, std::move(shape)));
}

// {1, 2} or {{1, 2}, {3, 4}}, over as many lines as it takes. Rows that end early leave the rest 0.
void read_array_values(Reading& reading, language::VariableId id, const std::vector<int>& shape) {
  TokenSource& tokens = reading.tokens;
  while (tokens.peek().is(TokenKind::newline)) tokens.take();
  const text::Place opener = tokens.peek().place;
  if (!tokens.peek().is_symbol("{"))
    throw text::Error(opener, "the values of an array stand in braces", "write = {1, 2, 3}");
  std::vector<std::size_t> below(shape.size() + 1, 1);  // numbers in one item, this many braces deep
  for (std::size_t d = shape.size(); d-- > 0;) below[d] = below[d + 1] * static_cast<std::size_t>(shape[d]);
  std::vector<std::size_t> ends;  // of the open braces
  std::size_t at = 0;
  do {
    const Token& token = tokens.peek();
    if (token.is(TokenKind::newline)) {
      tokens.take();
    } else if (token.is_symbol("{") && ends.size() < shape.size()) {
      ends.push_back(at + below[ends.size()]);
      tokens.take();
    } else if (token.is_symbol("}")) {
      at = ends.back();
      ends.pop_back();
      tokens.take();
    } else {
      const text::Place place = token.place;
      const double value = top_value(reading, "a number, or a brace, is missing in the values of an array");
      if (at >= ends.back()) throw text::Error(place, "these are more values than the array has room for");
      reading.scene.variables.set_component(id, at++, value);
    }
  } while (!ends.empty());
}

void read_array(Reading& reading, const Token& name) {
  const std::vector<int> shape = read_shape(reading);
  set_variable(reading, name, 0.0, false);
  const std::optional<language::VariableId> id = reading.scene.variables.find_id(name.text);
  if (!id) throw text::Error(name.place, fmt::format("\"{}\" cannot be an array", name.text));
  reading.scene.variables.set_shape(*id, shape);
  if (take_equals(reading)) read_array_values(reading, *id, shape);
}

void read_variable(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  const Token name = take_new_name(reading, "a variable");
  const Token type = tokens.take();
  const bool string = type.is_word("string");
  if (!string && !type.is_word("real") && !type.is_word("integer")) {
    throw text::Error(type.place,
                      fmt::format("expected the type of \"{}\", found {}", name.text, describe(type)),
                      "write real, integer or string");
  }
  if (tokens.peek().is_symbol("[")) {
    if (string) throw text::Error(type.place, "arrays hold numbers", "write real or integer");
    read_array(reading, name);
    return;
  }
  language::Value value = string ? language::Value(std::string{}) : language::Value(0.0);
  if (take_equals(reading)) value = top_formula(reading);
  set_variable(reading, name, std::move(value), false);
}

// --- functions and procedures

bool brace_follows(TokenSource& tokens) {
  std::size_t ahead = 0;
  while (tokens.peek(ahead).is(TokenKind::newline)) ++ahead;
  return tokens.peek(ahead).is_symbol("{");
}

}  // namespace

void read_parameter(Reading& reading, bool optimized) {
  const Token name = take_new_name(reading, "a parameter");
  const text::Place after = reading.tokens.peek().place;
  const bool equals = take_equals(reading);
  if (!top_value_follows(reading) && !reading.tokens.peek().is(TokenKind::string)) {
    throw text::Error(equals ? reading.tokens.peek().place : after,
                      fmt::format("the parameter \"{}\" needs a value", name.text),
                      fmt::format("write parameter {} = 1", name.text));
  }
  if (!equals) {
    reading.findings.warning(after, fmt::format("a \"=\" is missing after the name \"{}\"", name.text));
  }
  language::Value value = top_formula(reading);
  if (optimized && !std::holds_alternative<double>(value))
    throw text::Error(name.place, fmt::format("\"{}\" is text, which cannot be optimized", name.text));
  set_variable(reading, name, std::move(value), true);
  scene::FreeParameter parameter;
  parameter.fixed = !optimized;
  if (!read_parameter_options(reading, parameter) && !optimized) return;
  const auto variable = reading.scene.variables.find_id(name.text);
  if (!variable) throw text::Error(name.place, fmt::format("\"{}\" cannot be optimized", name.text));
  parameter.variable = *variable;
  reading.scene.parameters.push_back(parameter);
}

void read_define(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  const bool attribute = tokens.peek(1).is_word("attribute");
  const auto kind =
      tokens.peek().is(TokenKind::word) ? language::element_kind(tokens.peek().text) : std::nullopt;
  if (attribute && !kind) {
    throw text::Error(tokens.peek().place, fmt::format("{} is no kind of element", describe(tokens.peek())),
                      "attributes are those of a vertex, edge, facet or body");
  }
  if (!attribute) {
    read_variable(reading);
    return;
  }
  tokens.take();
  tokens.take();
  read_attribute(reading, static_cast<film::ElementKind>(*kind));
}

void keep_procedure(Reading& reading, const Token& word) {
  TokenSource& tokens = reading.tokens;
  std::vector<text::Place> open;
  text::Place last = word.place;
  while (true) {
    const Token token = tokens.peek();
    if (token.is(TokenKind::end) && !open.empty())
      throw text::Error(open.back(), "this \"{\" is never closed: missing \"}\"");
    const bool ends = token.is(TokenKind::end) || (token.is(TokenKind::newline) && !brace_follows(tokens));
    if (ends && open.empty()) break;
    tokens.take();
    if (!token.is(TokenKind::newline)) last = token.place;
    if (token.is_symbol("{")) open.push_back(token.place);
    if (token.is_symbol("}") && !open.empty()) open.pop_back();
    if (token.is_symbol("}") && open.empty()) break;
  }
  text::Place whole = language::join(word.place, last);
  const std::string_view content = whole.source->content;
  const std::size_t end = std::size_t{whole.offset} + whole.length;
  if (end < content.size() && content[end] == ';') ++whole.length;
  reading.procedures.push_back(std::move(whole));
}

}  // namespace lamella::datafile
