// Formulas of elements, evaluated: what colours pictures, sizes meshes and goes into exported columns.
#pragma once

#include <vector>

#include "session/arguments.h"

namespace lamella::session {

class Session;

// The values of a formula for all elements of its kind, one a row; not a number for tombstones.
std::vector<double> values_of(Session& session, const Field& field);

}  // namespace lamella::session
