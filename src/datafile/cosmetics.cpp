#include "datafile/cosmetics.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "datafile/reading.h"
#include "datafile/top_values.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using Shape = CosmeticShape;

constexpr int matrix_size = 16;
constexpr double most_transforms = 10000;

constexpr std::array<CosmeticWord, 21> table = {{
    {"soapfilm", Shape::nothing, false},
    {"linear", Shape::nothing, false},
    {"vertices_predicted", Shape::number, false},
    {"edges_predicted", Shape::number, false},
    {"facets_predicted", Shape::number, false},
    {"facetedges_predicted", Shape::number, false},
    {"bodies_predicted", Shape::number, false},
    {"quantities_predicted", Shape::number, false},
    {"method_instances_predicted", Shape::number, false},
    {"evolver_version", Shape::string},
    {"view_matrix", Shape::matrix},
    {"view_transforms", Shape::transforms},
    {"view_transform_generators", Shape::transforms},
    {"zoom_vertex", Shape::number},
    {"zoom_radius", Shape::number},
    {"clip_coeff", Shape::braces},
    {"slice_coeff", Shape::braces},
    {"display_origin", Shape::braces},
    {"suppress_warning", Shape::number},
    {"unsuppress_warning", Shape::number},
    {"merit_factor", Shape::optional_number},
}};

std::string number_text(Reading& reading, std::string_view word) {
  return fmt::format("{}", top_value(reading, fmt::format("\"{}\" needs a number", word)));
}

// Four lines of four numbers.
std::string matrix_text(Reading& reading, std::string_view word) {
  std::string text;
  for (int i = 0; i < matrix_size; ++i) {
    TokenSource& tokens = reading.tokens;
    while (tokens.peek().is(language::TokenKind::newline)) tokens.take();
    const std::string missing = fmt::format("a matrix of \"{}\" has {} numbers, and only {} {} given", word,
                                            matrix_size, i, i == 1 ? "is" : "are");
    text += fmt::format("{}{}", i % 4 == 0 ? "\n" : " ", top_value(reading, missing));
  }
  return text;
}

std::string transforms_text(Reading& reading, std::string_view word) {
  TokenSource& tokens = reading.tokens;
  const text::Place place = tokens.peek().place;
  const double count = top_value(reading, fmt::format("\"{}\" needs the number of matrices", word));
  if (count < 0 || count > most_transforms || count != static_cast<int>(count)) {
    throw text::Error(place, fmt::format("{} is no number of matrices", count));
  }
  std::string text = fmt::format("{}", count);
  for (int i = 0; i < static_cast<int>(count); ++i) {
    while (tokens.peek().is(language::TokenKind::newline)) tokens.take();
    if (tokens.peek().is_word("color")) {
      tokens.take();
      text += fmt::format("\ncolor {}", number_text(reading, "color"));
    } else if (tokens.peek().is_word("swap_colors")) {
      tokens.take();
      text += "\nswap_colors";
    }
    text += matrix_text(reading, word);
  }
  return text;
}

// Braces, with numbers or further braces between them.
std::string braces_text(Reading& reading, std::string_view word) {
  TokenSource& tokens = reading.tokens;
  if (tokens.peek().is_symbol("=")) tokens.take();
  const text::Place opener = tokens.peek().place;
  std::string text = "= ";
  int depth = 0;
  do {
    const language::Token& token = tokens.peek();
    const bool follows = text.back() != ' ' && text.back() != '{';
    if (token.is_symbol("}") && depth > 0) {
      text += tokens.take().text;
      --depth;
    } else if (token.is_symbol("{")) {
      text += fmt::format("{}{}", follows ? "," : "", tokens.take().text);
      ++depth;
    } else if (token.is(language::TokenKind::newline) && depth > 0) {
      tokens.take();
    } else if (depth > 0 && top_value_follows(reading)) {
      text += fmt::format("{}{}", follows ? "," : "", number_text(reading, word));
    } else {
      throw text::Error(depth > 0 ? token.place : opener, fmt::format("\"{}\" needs numbers in braces", word),
                        "write = {1, 0, 0, 0}");
    }
  } while (depth > 0);
  return text;
}

std::string string_text(Reading& reading, std::string_view word) {
  const language::Token token = reading.tokens.peek();
  if (!token.is(language::TokenKind::string)) {
    throw text::Error(token.place, fmt::format("\"{}\" needs a text in quotes", word));
  }
  reading.tokens.take();
  return std::string(token.text);
}

std::string shape_text(Reading& reading, const CosmeticWord& word) {
  switch (word.shape) {
    case Shape::nothing:
      return {};
    case Shape::number:
      return number_text(reading, word.word);
    case Shape::optional_number:
      return top_value_follows(reading) ? number_text(reading, word.word) : std::string{};
    case Shape::string:
      return string_text(reading, word.word);
    case Shape::braces:
      return braces_text(reading, word.word);
    case Shape::matrix:
      return matrix_text(reading, word.word);
    case Shape::transforms:
      return transforms_text(reading, word.word);
  }
  return {};
}

}  // namespace

const CosmeticWord* cosmetic_word(std::string_view word) {
  const std::string key = text::lower(word);
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const CosmeticWord& entry) { return entry.word == key; });
  return at == table.end() ? nullptr : &*at;
}

void collect_cosmetics(std::vector<std::string>& into) {
  for (const CosmeticWord& entry : table) into.emplace_back(entry.word);
}

void read_cosmetic(Reading& reading, const CosmeticWord& word) {
  std::string text = shape_text(reading, word);
  if (word.kept) reading.scene.cosmetics.push_back({std::string(word.word), std::move(text)});
}

}  // namespace lamella::datafile
