// From what the lists say of constraints and boundaries to columns of the film, and vertices to where they
// belong.
#pragma once

#include "datafile/reading.h"

namespace lamella::datafile {

// Turns the parameters of vertices on boundaries into positions. Notes where a boundary has none.
void place_on_boundaries(Reading& reading);

// The film's columns, wide enough for whatever new elements inherit. After the vertices, edges and faces of
// the file were added.
void add_constraints(Reading& reading);

// Puts vertices onto their constraints, fixed ones too: those of the file, and warns of those that cannot be
// put there; then those from a row on, the centres of faces, which are the means of projected corners.
void project_vertices_of_file(Reading& reading);
void project_centres(Reading& reading);

}  // namespace lamella::datafile
