// The values that a session knows by name without anyone having defined them: `total_area`, `vertex_count`,
// `clock`.
#pragma once

#include <span>
#include <string_view>

#include "language/expression.h"
#include "language/variables.h"

namespace lamella::session {

class Session;

struct InternalVariable {
  std::string_view name;
  std::string_view summary;
  language::Value (*get)(Session&) = nullptr;
  void (*set)(Session&, double value) = nullptr;  // null: cannot be set
};

std::span<const InternalVariable> internal_variables();
// Case does not matter.
std::optional<language::InternalId> find_internal_variable(std::string_view name);
const InternalVariable& internal_variable(language::InternalId id);

}  // namespace lamella::session
