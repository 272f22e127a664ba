// What `fix` and `unfix` share.
#pragma once

#include "session/command.h"

namespace lamella::session {

// Returns how many elements were not so before. Throws for bodies.
long set_fixed(Session& session, const Elements& elements, bool fixed);

}  // namespace lamella::session
