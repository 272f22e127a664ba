// The lists of a saved datafile.
#pragma once

#include <string>

#include "film/column.h"
#include "scene/scene.h"

namespace lamella::datafile {

// Whether the numbers of elements are others than a reader would give them.
bool needs_own_numbers(const scene::Scene& scene);

// Whether a column is written under a name that the top section declares.
bool is_declared_column(film::ElementKind kind, const film::Column& column);

// Vertices, edges, faces, bodies. Throws text::Error where a number is not finite.
void write_elements(std::string& out, const scene::Scene& scene);

}  // namespace lamella::datafile
