// What holds elements, as attributes: `on_constraint 1`, `on_boundary 2`, `p1`, `set vertex constraint 3`.
#pragma once

#include <deque>

#include "session/attributes.h"

namespace lamella::session {

void add_constraint_attributes(std::deque<AttributeRow>& rows);

}  // namespace lamella::session
