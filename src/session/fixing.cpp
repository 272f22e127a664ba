#include "session/fixing.h"

#include "session/session.h"

namespace lamella::session {

long set_fixed(Session& session, const Elements& elements, bool fixed) {
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
