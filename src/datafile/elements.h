// The lists of a datafile: vertices, edges, faces, bodies.
#pragma once

#include <optional>

#include "datafile/reading.h"
#include "text/source.h"

namespace lamella::datafile {

// Reads all lists into reading.rows, up to `read` or to the end of the file. Whether `read` was met.
bool read_lists(Reading& reading);

}  // namespace lamella::datafile
