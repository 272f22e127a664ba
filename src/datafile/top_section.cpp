#include "datafile/top_section.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "datafile/constraints.h"
#include "datafile/cosmetics.h"
#include "datafile/definitions.h"
#include "datafile/keywords.h"
#include "datafile/quantities.h"
#include "datafile/settings.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using language::Token;
using language::TokenKind;

bool is_declaration_word(std::string_view word) {
  constexpr std::array<std::string_view, 11> words = {
      "parameter",      "optimizing_parameter", "optimising_parameter", "define",   "function",
      "procedure",      "constraint",           "constraints",          "boundary", "quantity",
      "method_instance"};
  return std::find(words.begin(), words.end(), text::lower(word)) != words.end();
}

// `function:` is also a line of a constraint, where a type makes it a declaration.
bool at_declaration(TokenSource& tokens) {
  const Token& token = tokens.peek();
  if (token.is(TokenKind::end)) return true;
  if (!token.is(TokenKind::word) || !begins_declaration(token.text)) return false;
  if (!token.is_word("function")) return true;
  const Token& type = tokens.peek(1);
  return type.is_word("real") || type.is_word("integer") || type.is_word("string");
}

[[noreturn]] void refuse_word(const Token& word) {
  std::vector<std::string> known{"parameter", "define",     "function", "procedure",           "#define",
                                 "#include",  "constraint", "boundary", "optimizing_parameter"};
  for (const Setting& setting : settings()) known.emplace_back(setting.word);
  collect_sections(known);
  collect_cosmetics(known);
  collect_refused(known);
  std::string hint = text::did_you_mean(word.text, known);
  if (is_command_word(word.text)) hint = "commands go after \"read\" at the end of the datafile";
  if (hint.empty())
    hint = "the lists of a datafile begin with vertices, edges, faces and bodies, its commands with read";
  throw text::Error(word.place, fmt::format("unknown keyword \"{}\"", word.text), hint);
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
    read_parameter(reading, false);
  } else if (word.is_word("optimizing_parameter") || word.is_word("optimising_parameter")) {
    read_parameter(reading, true);
  } else if (word.is_word("define")) {
    read_define(reading);
  } else if (word.is_word("function") || word.is_word("procedure")) {
    keep_procedure(reading, word);
  } else if (word.is_word("constraint") || word.is_word("constraints")) {
    read_constraint(reading, word);
  } else if (word.is_word("boundary")) {
    read_boundary(reading, word);
  } else if (word.is_word("quantity")) {
    read_quantity(reading, word);
  } else if (word.is_word("method_instance")) {
    read_method_instance(reading, word);
  } else if (const Setting* setting = find_setting(word.text)) {
    setting->read(reading, word);
  } else if (const CosmeticWord* cosmetic = cosmetic_word(word.text)) {
    read_cosmetic(reading, *cosmetic);
  } else if (const auto feature = refused_feature(word.text)) {
    reading.refuse(word.place, text::lower(word.text), *feature);
    skip_declaration(tokens);
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

bool begins_declaration(std::string_view word) {
  return is_declaration_word(word) || find_setting(word) != nullptr || cosmetic_word(word) != nullptr ||
         refused_feature(word).has_value() || section_named(word).has_value();
}

void skip_declaration(TokenSource& tokens) {
  while (!tokens.at_line_start() || !at_declaration(tokens)) tokens.next_line();
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
        [&] { skip_declaration(tokens); });
  }
}

}  // namespace lamella::datafile
