// Formulas from text, for tests.
#pragma once

#include <string>

#include "language/formula_scope.h"
#include "language/lexer.h"
#include "scene/scene.h"

namespace lamella::test {

inline language::Formula formula(const std::string& text,
                                 language::FormulaKind kind = language::FormulaKind::space,
                                 const language::Variables& variables = {}) {
  language::LexerStream tokens(
      language::Lexer(text::make_source("formula", text), language::LexerMode::datafile));
  language::Formula result = language::parse_formula(tokens, kind, variables, {});
  result.bind(variables);
  return result;
}

inline scene::EdgeIntegrand field(const std::string& x, const std::string& y, const std::string& z) {
  return {formula(x), formula(y), formula(z)};
}

inline scene::LevelSet level_set(const std::string& text) {
  scene::LevelSet set;
  set.formula = formula(text);
  return set;
}

}  // namespace lamella::test
