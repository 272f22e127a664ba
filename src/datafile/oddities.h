// What is legal and hardly meant: warnings.
#pragma once

#include "datafile/reading.h"
#include "datafile/resolve.h"

namespace lamella::datafile {

// Vertices at the same point, faces with the same vertices, faces without area.
void warn_of_oddities(Reading& reading, const Resolved& resolved);

}  // namespace lamella::datafile
