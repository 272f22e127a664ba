// Elements as lines of a datafile.
#pragma once

#include <string>

#include "session/attributes.h"
#include "session/command.h"

namespace lamella::session {

// A comment that names the columns, then one line for each element (bodies may take several), in stored
// orientation.
std::string listing(const AttributeSource& source, const Elements& elements);

}  // namespace lamella::session
