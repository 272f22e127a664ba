#include "language/formula_scope.h"

#include <array>

#include "language/expression_parser.h"

namespace lamella::language {

FormulaScope::FormulaScope(FormulaKind kind, const Variables& variables,
                           const std::vector<std::string>& attributes)
    : variables_(variables) {
  // The order of the slots is what Formula expects.
  const bool space = kind == FormulaKind::space;
  for (const char* name : space ? std::array{"x", "y", "z"} : std::array{"p1", "p2", "p3"})
    locals().declare(name);
  locals().declare("total_time");
  for (const std::string& name : attributes) locals().declare(name);
  if (!space) return;
  for (const char* name : {"x1", "x2", "x3"}) locals().declare(name);
}

std::optional<VariableId> FormulaScope::variable(std::string_view name) const {
  return ConstantScope(variables_).variable(name);
}

void FormulaScope::collect_names(std::vector<std::string>& into) const {
  ConstantScope(variables_).collect_names(into);
  for (const Local& local : locals().names()) into.push_back(local.name);
}

Formula parse_formula(TokenStream& tokens, FormulaKind kind, const Variables& variables,
                      const std::vector<std::string>& attributes) {
  FormulaScope scope(kind, variables, attributes);
  ExpressionParser parser(tokens, scope, ExpressionStyle::formula);
  std::shared_ptr<const Expression> expression = parser.expression();
  const text::Place place = expression->place;
  std::string text = place.known() ? place.source->content.substr(place.offset, place.length) : std::string();
  return Formula(std::move(expression), std::move(text), attributes);
}

}  // namespace lamella::language
