// Rows and tables that several commands print.
#pragma once

#include <string>

#include "energy/measure.h"
#include "scene/scene.h"

namespace lamella::session {

// `Vertices: 50  Edges: 144  Facets: 96  Bodies: 1  Facetedges: 288` and a newline.
std::string counts_row(const scene::Scene& scene);

// Target volume, actual volume and pressure of each body, a line each under a heading. A pressure is the
// multiplier of the last step that computed one.
std::string volume_table(const scene::Scene& scene, const energy::Measures& measures);

}  // namespace lamella::session
