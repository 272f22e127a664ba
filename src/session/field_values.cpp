#include "session/field_values.h"

#include <limits>

#include "session/element_access.h"
#include "session/session.h"

namespace lamella::session {

std::vector<double> values_of(Session& session, const Field& field) {
  const scene::Scene& scene = session.scene();
  language::Evaluation& evaluation = session.evaluation();
  std::vector<double> values(row_count(scene, field.kind), std::numeric_limits<double>::quiet_NaN());
  for (std::uint32_t row = 0; row < values.size(); ++row) {
    if (!is_alive(scene, field.kind, row)) continue;
    evaluation.local(field.slot) = language::Element{field.kind, row, false};
    values[row] = language::evaluate_number(*field.value, evaluation);
  }
  return values;
}

}  // namespace lamella::session
