// What `fix` and `unfix` share.
#pragma once

#include "session/command.h"

namespace lamella::session {

// Elements, or one parameter by its name.
struct Fixable {
  std::optional<Elements> elements;
  std::optional<Word> parameter;
};

// Returns how many elements were not so before. Throws for bodies, and for names that no
// parameter has.
long set_fixed(Session& session, const Fixable& what, bool fixed);

}  // namespace lamella::session
