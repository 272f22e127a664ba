#include "session/fixing.h"

#include "session/parameter_parts.h"
#include "session/session.h"
#include "text/suggest.h"

namespace lamella::session {

namespace {

long set_fixed(Session& session, const Word& parameter, bool fixed) {
  if (const auto changed = fix_parameter(session.scene(), parameter.text, fixed)) return *changed ? 1 : 0;
  std::vector<std::string> known{"vertices", "edges", "facets"};
  session.scene().variables.for_each([&](language::VariableId id, const language::Variable& variable) {
    if (variable.parameter) known.push_back(session.scene().variables.name(id));
  });
  std::string hint = text::did_you_mean(parameter.text, known);
  if (hint.empty())
    hint = "fix takes elements, as in fix vertices where z == 0, or a parameter of the datafile";
  throw text::Error(parameter.place, fmt::format("\"{}\" cannot be fixed", parameter.text), hint);
}

}  // namespace

long set_fixed(Session& session, const Fixable& what, bool fixed) {
  if (what.elements.has_value() == what.parameter.has_value())
    throw text::Error("fix and unfix take elements or the name of a parameter",
                      "as in: fix vertices where z == 0");
  if (what.parameter) return set_fixed(session, *what.parameter, fixed);
  const Elements& elements = *what.elements;
  if (elements.kind == language::ElementKind::body) {
    throw text::Error("bodies cannot be fixed", "for a fixed volume: set body[1] target 1.5");
  }
  const auto attribute = session.attributes().find(session.scene(), elements.kind, "fixed");
  const AttributeSource source = session.attribute_source();
  const double wanted = fixed ? 1 : 0;
  long changed = 0;
  for (const language::Element& element : elements.list) {
    if (session.attributes().get(source, attribute->id, element, 0) == wanted) continue;
    session.attributes().set(source, attribute->id, element, 0, wanted);
    ++changed;
  }
  return changed;
}

}  // namespace lamella::session
