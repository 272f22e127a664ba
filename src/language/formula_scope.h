// The names that a formula may use: coordinates, the time, G for the constant of gravity, the scene's
// variables, attributes.
#pragma once

#include <string>
#include <vector>

#include "language/expression_parser.h"
#include "language/formula.h"
#include "language/scope.h"
#include "language/token.h"

namespace lamella::language {

enum class FormulaKind : std::uint8_t {
  space,             // x, y, z, also x1, x2, x3
  parameter,         // p1, p2, p3
  space_and_normal,  // x, y, z, and x4, x5, x6 for the components of a normal
  variables,         // no coordinates, and no time
};

// `attributes` are the names of the vertex attributes that have one number.
class FormulaScope : public Scope {
 public:
  FormulaScope(FormulaKind kind, const Variables& variables, const std::vector<std::string>& attributes);

  std::optional<VariableId> variable(std::string_view name) const override;
  void collect_names(std::vector<std::string>& into) const override;

 private:
  const Variables& variables_;
};

// Parses one formula from a stream of tokens and compiles it. Its text is made of the tokens, so macros stand
// replaced in it. Errors have their place.
Formula parse_formula(TokenStream& tokens, FormulaKind kind, const Variables& variables,
                      const std::vector<std::string>& attributes,
                      ExpressionStyle style = ExpressionStyle::formula);

}  // namespace lamella::language
