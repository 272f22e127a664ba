// The values that a session knows by name without anyone having defined them: `total_area`, `vertex_count`,
// `clock`.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "language/expression.h"
#include "language/variables.h"

namespace lamella::session {

class Session;

struct InternalVariable {
  std::string_view name;
  std::string_view summary;
  std::function<language::Value(Session&)> get;
  std::function<void(Session&, double value)> set;  // empty: cannot be set
};

std::span<const InternalVariable> internal_variables();
// Case does not matter.
std::optional<language::InternalId> find_internal_variable(std::string_view name);
const InternalVariable& internal_variable(language::InternalId id);

}  // namespace lamella::session
