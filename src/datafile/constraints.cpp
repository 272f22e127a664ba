#include "datafile/constraints.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "datafile/top_section.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using language::Formula;
using language::FormulaKind;
using language::Token;
using language::TokenKind;

constexpr double largest_number = 1000000;

std::size_t blank_lines(TokenSource& tokens) {
  std::size_t ahead = 0;
  while (tokens.peek(ahead).is(TokenKind::newline)) ++ahead;
  return ahead;
}

// Takes one of some words if it is next, on this line or a later one.
bool accept_word(TokenSource& tokens, std::initializer_list<std::string_view> words) {
  const std::size_t ahead = blank_lines(tokens);
  const Token& token = tokens.peek(ahead);
  const bool found =
      std::any_of(words.begin(), words.end(), [&](std::string_view word) { return token.is_word(word); });
  if (!found) return false;
  for (std::size_t i = 0; i <= ahead; ++i) tokens.take();
  return true;
}

// The user's attributes of one number that are named on this line.
std::vector<std::string> attributes_named(Reading& reading, film::ElementKind element) {
  std::vector<std::string> names;
  int open = 0;
  bool waiting = false;  // for an operand, which may stand on the next line
  for (std::size_t ahead = 0;; ++ahead) {
    const Token& token = reading.tokens.peek(ahead);
    waiting = waiting || token.separator == ':';
    if (token.is(TokenKind::end) || (token.is(TokenKind::newline) && open <= 0 && !waiting)) break;
    if (token.is_symbol("(")) ++open;
    if (token.is_symbol(")")) --open;
    if (!token.is(TokenKind::newline)) waiting = token.is(TokenKind::symbol) && !token.is_symbol(")");
    if (!token.is(TokenKind::word)) continue;
    const std::string key = text::lower(token.text);
    for (const film::Column& column : reading.rows.columns_of(element)) {
      const bool wanted = column.name == key && column.user_defined && column.width == 1;
      if (wanted && std::find(names.begin(), names.end(), key) == names.end()) names.push_back(key);
    }
  }
  return names;
}

int whole_number(const Token& token, std::string_view what) {
  if (token.number < 1 || token.number > largest_number || token.number != std::floor(token.number)) {
    throw text::Error(token.place,
                      fmt::format("the number of a {} is a whole number from 1, not {}", what, token.text));
  }
  return static_cast<int>(token.number);
}

using Names = std::map<std::string, int, std::less<>>;

template <class Declared>
int number_above_all(const Names& names, const Declared& declared) {
  int highest = declared.empty() ? 0 : declared.rbegin()->first;
  for (const auto& [name, number] : names) highest = std::max(highest, number);
  return highest + 1;
}

// A name that had the number gets another.
template <class Declared>
void make_way(int number, Names& names, Declared& declared) {
  for (auto& [name, taken] : names) {
    if (taken != number) continue;
    taken = number_above_all(names, declared);
    if (auto node = declared.extract(number)) {
      node.key() = taken;
      declared.insert(std::move(node));
    }
  }
}

// The number that a declaration is about. A name gets one above all others.
template <class Declared>
int take_number(Reading& reading, const Token& word, Names& names, Declared& declared, std::string& name) {
  const Token token = reading.tokens.peek();
  if (!token.is(TokenKind::number) && !token.is(TokenKind::word)) {
    throw text::Error(token.place, fmt::format("\"{}\" needs a number or a name", word.text));
  }
  reading.tokens.take();
  if (token.is(TokenKind::number)) {
    const int number = whole_number(token, text::lower(word.text));
    make_way(number, names, declared);
    return number;
  }
  name = text::lower(token.text);
  return names.try_emplace(name, number_above_all(names, declared)).first->second;
}

void refuse_again(const Token& word, const Token& number, bool declared) {
  if (!declared) return;
  throw text::Error(number.place,
                    fmt::format("the {} {} is declared already", text::lower(word.text), number.text));
}

// --- integrals along edges

// `energy:` with lines `e1: formula` to `e3: formula`, if it is there.
std::optional<scene::EdgeIntegrand> read_integrand(Reading& reading, std::string_view word,
                                                   std::string_view letter) {
  if (!accept_word(reading.tokens, {word})) return std::nullopt;
  return read_components(reading, letter, FormulaKind::space, film::ElementKind::edge);
}

template <class Set>
void read_integrals(Reading& reading, Set& set) {
  for (int i = 0; i < 2; ++i) {
    if (!set.energy) set.energy = read_integrand(reading, "energy", "e");
    if (!set.content) set.content = read_integrand(reading, "content", "c");
  }
}

// --- constraints

// Takes one word that says something of a constraint, if there is one.
bool read_flag(Reading& reading, scene::LevelSet& set) {
  TokenSource& tokens = reading.tokens;
  if (accept_word(tokens, {"global"})) {
    set.global = true;
  } else if (accept_word(tokens, {"convex"})) {
    set.convex = true;
  } else if (accept_word(tokens, {"nonnegative"})) {
    set.sense = scene::Sense::nonnegative;
  } else if (accept_word(tokens, {"nonpositive"})) {
    set.sense = scene::Sense::nonpositive;
  } else if (accept_word(tokens, {"nonwall"})) {
    set.nonwall = true;
  } else if (tokens.peek().is_word("content_rank")) {
    reading.refuse(tokens.peek().place, "content_rank", "ranks of content integrals");
    tokens.skip_line();
  } else {
    return false;
  }
  return true;
}

// --- boundaries

int take_parameter_count(Reading& reading, const Token& boundary) {
  TokenSource& tokens = reading.tokens;
  if (!accept_word(tokens, {"parameters", "parameter"})) {
    throw text::Error(tokens.peek().place,
                      fmt::format("the boundary {} needs its number of parameters", boundary.text),
                      "write boundary 1 parameters 1");
  }
  const Token count = tokens.peek();
  if (!count.is(TokenKind::number) || (count.number != 1 && count.number != 2 && count.number != 3)) {
    throw text::Error(count.place, "a boundary has one, two or three parameters");
  }
  tokens.take();
  return static_cast<int>(count.number);
}

// Integrands may depend on places alone.
void refuse_parameters(Reading& reading) {
  TokenSource& tokens = reading.tokens;
  for (std::size_t ahead = 0; !tokens.peek(ahead).ends_line(); ++ahead) {
    const Token& token = tokens.peek(ahead);
    const bool parameter = token.is_word("p1") || token.is_word("p2") || token.is_word("p3");
    if (parameter && !reading.scene.variables.find_id(token.text))
      reading.refuse(token.place, token.text, "parameters of boundaries in integrands");
  }
}

}  // namespace

Formula read_formula(Reading& reading, FormulaKind kind, film::ElementKind element) {
  if (kind != FormulaKind::parameter) refuse_parameters(reading);
  return language::parse_formula(reading.tokens, kind, reading.scene.variables,
                                 attributes_named(reading, element));
}

std::array<Formula, 3> read_components(Reading& reading, std::string_view letter, FormulaKind kind,
                                       film::ElementKind element) {
  TokenSource& tokens = reading.tokens;
  constexpr std::string_view axes = "xyz";  // other names of x1, x2, x3
  std::array<Formula, 3> components;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = fmt::format("{}{}", letter, i + 1);
    const std::string_view axis = axes.substr(i, letter == "x" ? 1 : 0);
    if (!accept_word(tokens, {name, axis})) continue;
    components[i] = read_formula(reading, kind, element);
    ++found;
  }
  if (found > 0) return components;
  throw text::Error(
      tokens.peek(blank_lines(tokens)).place,
      fmt::format("expected the component {}1, found {}", letter, describe(tokens.peek(blank_lines(tokens)))),
      fmt::format("write {}1: formula, and {}2 and {}3 likewise", letter, letter, letter));
}

void read_constraint(Reading& reading, const Token& word) {
  const Token named = reading.tokens.peek();
  scene::LevelSet set;
  const int number = take_number(reading, word, reading.constraint_names, reading.scene.level_sets, set.name);
  bool flags = false;
  while (read_flag(reading, set)) flags = true;
  if (!accept_word(reading.tokens, {"formula", "function", "equation"})) {
    if (!set.name.empty() && !flags) return;  // only announced
    throw text::Error(reading.tokens.peek().place,
                      fmt::format("the constraint {} needs a formula", named.text), "write formula: z = 0");
  }
  refuse_again(word, named, reading.scene.level_sets.contains(number));
  set.formula = read_formula(reading, FormulaKind::space, film::ElementKind::vertex);
  read_integrals(reading, set);
  reading.scene.level_sets[number] = std::move(set);
}

void read_boundary(Reading& reading, const Token& word) {
  const Token named = reading.tokens.peek();
  scene::Boundary boundary;
  const int number =
      take_number(reading, word, reading.boundary_names, reading.scene.boundaries, boundary.name);
  if (!boundary.name.empty() && reading.tokens.peek().ends_line()) return;  // only announced
  boundary.parameters = take_parameter_count(reading, named);
  const text::Place here = reading.tokens.peek().place;
  if (accept_word(reading.tokens, {"convex"})) {
    boundary.convex = true;
    if (boundary.parameters > 1)
      reading.refuse(here, "convex", "gap energies at boundaries of two parameters");
  }
  refuse_again(word, named, reading.scene.boundaries.contains(number));
  boundary.position = read_components(reading, "x", FormulaKind::parameter, film::ElementKind::vertex);
  read_integrals(reading, boundary);
  reading.scene.boundaries[number] = std::move(boundary);
}

namespace {

template <class Declared>
int declared_number(const Token& token, const std::map<std::string, int, std::less<>>& names,
                    const Declared& declared) {
  if (token.is(TokenKind::number)) {
    const bool whole =
        token.number >= 1 && token.number <= largest_number && token.number == std::floor(token.number);
    return whole && declared.contains(static_cast<int>(token.number)) ? static_cast<int>(token.number) : 0;
  }
  const auto at = names.find(text::lower(token.text));
  return at != names.end() && declared.contains(at->second) ? at->second : 0;
}

}  // namespace

int declared_constraint(const Reading& reading, const Token& token) {
  return declared_number(token, reading.constraint_names, reading.scene.level_sets);
}

int declared_boundary(const Reading& reading, const Token& token) {
  return declared_number(token, reading.boundary_names, reading.scene.boundaries);
}

}  // namespace lamella::datafile
