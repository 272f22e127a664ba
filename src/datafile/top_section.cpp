#include "datafile/top_section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/cosmetics.h"
#include "datafile/keywords.h"
#include "language/elements.h"
#include "language/evaluate.h"
#include "language/expression_parser.h"
#include "language/functions.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using language::Token;
using language::TokenKind;

constexpr std::size_t most_dimensions = 8;
constexpr double largest_width = 10000;

// --- values

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

// --- settings

// `at` is the place of the value.
using Setting = void (*)(Reading& reading, double value, const text::Place& at);

void set_scale(Reading& reading, double value, const text::Place&) {
  reading.scene.scale.value = value;
  if (!reading.tokens.peek().is_word("fixed")) return;
  reading.tokens.take();
  reading.scene.scale.fixed = true;
}

void require(double value, double wanted, std::string_view word, std::string_view feature, Reading& reading,
             const text::Place& at) {
  if (value != wanted) reading.refuse(at, word, feature);
}

struct NumberSetting {
  std::string_view word;
  Setting set;
};

constexpr std::array<NumberSetting, 4> number_settings = {{
    {"gravity_constant",
     [](Reading& r, double value, const text::Place&) { r.scene.gravity.constant = value; }},
    {"scale", set_scale},
    {"scale_limit", [](Reading& r, double value, const text::Place&) { r.scene.scale.limit = value; }},
    {"total_time", [](Reading& r, double value, const text::Place&) { r.scene.time = value; }},
}};

// Their place is that of the keyword: it is what cannot be had.
constexpr std::array<NumberSetting, 2> dimensions = {{
    {"space_dimension",
     [](Reading& r, double value, const text::Place& at) {
       require(value, 3, "space_dimension", "only space of three dimensions is", r, at);
     }},
    {"surface_dimension",
     [](Reading& r, double value, const text::Place& at) {
       require(value, 2, "surface_dimension", "only films of two dimensions are", r, at);
     }},
}};

struct Switch {
  std::string_view word;
  void (*set)(Reading&);
};

constexpr std::array<Switch, 3> switches = {{
    {"symmetric_content", [](Reading& r) { r.scene.symmetric_content = true; }},
    {"keep_originals", [](Reading& r) { r.keep_originals = true; }},
    {"keep_macros", [](Reading& r) { r.keep_macros = true; }},
}};

constexpr std::array<SettingParameter, 2> parameters = {{
    {"lamella_keep_volumes", [](const scene::Scene& s) { return s.keep_volumes ? 1.0 : 0.0; },
     [](scene::Scene& s, double value) { s.keep_volumes = value != 0; }, 1},
    {"lamella_damping", [](const scene::Scene& s) { return s.damping; },
     [](scene::Scene& s, double value) { s.damping = value; }, 0},
}};

template <class Table>
auto find_word(const Table& table, std::string_view word) {
  const std::string key = text::lower(word);
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.word == key; });
  return at == table.end() ? nullptr : &*at;
}

// --- parameters and variables

bool is_declaration_word(std::string_view word) {
  constexpr std::array<std::string_view, 4> words = {"parameter", "define", "function", "procedure"};
  return std::find(words.begin(), words.end(), text::lower(word)) != words.end();
}

bool begins_declaration(std::string_view word) {
  return is_declaration_word(word) || find_word(number_settings, word) != nullptr ||
         find_word(dimensions, word) != nullptr || find_word(switches, word) != nullptr ||
         cosmetic_word(word) != nullptr || refused_feature(word).has_value() ||
         section_named(word).has_value();
}

// A single letter may stand for anything, even where it is a number of its own (e).
bool is_taken(std::string_view name) {
  if (name.size() == 1) return false;
  return begins_declaration(name) || is_attribute_word(name) || language::element_kind(name).has_value() ||
         language::find_function(name) != nullptr || language::named_number(name).has_value();
}

Token take_new_name(Reading& reading, std::string_view what) {
  const Token name = reading.tokens.peek();
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
  const auto setting = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const SettingParameter& s) { return name.is_word(s.name); });
  const double* const number = std::get_if<double>(&value);
  if (setting != parameters.end() && number != nullptr) {
    setting->set(reading.scene, *number);
    return;
  }
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

// What may follow the value. Steps and weights only say something of parameters that are optimized.
void read_parameter_options(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  while (true) {
    const Token word = tokens.peek();
    const bool weight = word.is_word("pdelta") || word.is_word("pscale") ||
                        (word.is_word("scale") && tokens.peek(1).is_symbol("="));
    if (weight) {
      tokens.take();
      take_equals(reading);
      top_value(reading, fmt::format("\"{}\" needs a number", word.text));
    } else if (word.is_word("on_assign_call")) {
      reading.refuse(word.place, "on_assign_call", "procedures that run when a parameter changes");
      tokens.skip_line();
    } else {
      return;
    }
  }
}

void read_parameter(Reading& reading) {
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
  set_variable(reading, name, value_of_expression(reading, language::ExpressionStyle::formula), true);
  read_parameter_options(reading);
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
    reading.refuse(tokens.peek().place, "[", "arrays of variables");
    while (tokens.peek().is_symbol("[")) tokens.skip_line();
    return;
  }
  language::Value value = string ? language::Value(std::string{}) : language::Value(0.0);
  if (take_equals(reading)) value = value_of_expression(reading, language::ExpressionStyle::formula);
  set_variable(reading, name, std::move(value), false);
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

// --- functions and procedures

bool brace_follows(TokenSource& tokens) {
  std::size_t ahead = 0;
  while (tokens.peek(ahead).is(TokenKind::newline)) ++ahead;
  return tokens.peek(ahead).is_symbol("{");
}

// Kept as they stand, for whoever can run commands. Where no braces follow, it is an announcement, `procedure
// f();`.
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

// --- lines

// `function:` is also a line of a constraint, where a type makes it a declaration.
bool at_declaration(TokenSource& tokens) {
  const Token& token = tokens.peek();
  if (token.is(TokenKind::end)) return true;
  if (!token.is(TokenKind::word) || !begins_declaration(token.text)) return false;
  if (!token.is_word("function")) return true;
  const Token& type = tokens.peek(1);
  return type.is_word("real") || type.is_word("integer") || type.is_word("string");
}

// To the next line that begins with a keyword: the others belong to what could not be read.
void skip_declaration(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  if (!tokens.at_line_start()) tokens.skip_line();
  bool found = false;
  while (!found) {
    reading.attempt(
        [&] {
          while (tokens.peek().is(TokenKind::newline)) tokens.take();
          found = at_declaration(tokens);
        },
        [] {});
    if (!found) tokens.skip_line();
  }
}

[[noreturn]] void refuse_word(const Token& word) {
  std::vector<std::string> known{"parameter", "define", "function", "procedure", "#define", "#include"};
  for (const auto& entry : number_settings) known.emplace_back(entry.word);
  for (const auto& entry : dimensions) known.emplace_back(entry.word);
  for (const auto& entry : switches) known.emplace_back(entry.word);
  collect_sections(known);
  collect_cosmetics(known);
  collect_refused(known);
  std::string hint = text::did_you_mean(word.text, known);
  if (is_command_word(word.text)) hint = "commands go after \"read\" at the end of the datafile";
  if (hint.empty())
    hint = "the lists of a datafile begin with vertices, edges, faces and bodies, its commands with read";
  throw text::Error(word.place, fmt::format("unknown keyword \"{}\"", word.text), hint);
}

void read_setting(Reading& reading, const NumberSetting& setting) {
  const text::Place at = reading.tokens.peek().place;
  setting.set(reading, top_value(reading, fmt::format("\"{}\" needs a number", setting.word)), at);
}

void read_declaration(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  const Token word = tokens.peek();
  if (!word.is(TokenKind::word)) {
    throw text::Error(word.place,
                      fmt::format("expected a keyword such as vertices, found {}", describe(word)));
  }
  tokens.take();
  if (word.is_word("parameter")) {
    read_parameter(reading);
  } else if (word.is_word("define")) {
    read_define(reading);
  } else if (word.is_word("function") || word.is_word("procedure")) {
    keep_procedure(reading, word);
  } else if (const NumberSetting* setting = find_word(number_settings, word.text)) {
    read_setting(reading, *setting);
  } else if (const NumberSetting* dimension = find_word(dimensions, word.text)) {
    dimension->set(reading, top_value(reading, fmt::format("\"{}\" needs a number", word.text)), word.place);
  } else if (const Switch* flag = find_word(switches, word.text)) {
    flag->set(reading);
  } else if (const CosmeticWord* cosmetic = cosmetic_word(word.text)) {
    read_cosmetic(reading, *cosmetic);
  } else if (const auto feature = refused_feature(word.text)) {
    reading.refuse(word.place, text::lower(word.text), *feature);
    skip_declaration(reading);
  } else {
    refuse_word(word);
  }
}

bool misspelt_section(const Token& word) {
  std::vector<std::string> sections;
  collect_sections(sections);
  return !begins_declaration(word.text) && text::closest(word.text, sections).has_value();
}

}  // namespace

std::span<const SettingParameter> setting_parameters() {
  return parameters;
}

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

void read_top_section(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  bool at_section = false;
  while (!at_section && !reading.findings.too_many()) {
    reading.attempt(
        [&] {
          while (tokens.peek().is(TokenKind::newline)) tokens.take();
          const Token& token = tokens.peek();
          at_section = token.is(TokenKind::end) ||
                       (token.is(TokenKind::word) && (section_named(token.text) || misspelt_section(token)));
          if (!at_section) read_declaration(reading);
        },
        [&] { skip_declaration(reading); });
  }
}

}  // namespace lamella::datafile
