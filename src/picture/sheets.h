// Smooth normals within each film, with creases where films meet, end or bend sharply.
#pragma once

#include <cstdint>
#include <vector>

#include "film/film.h"
#include "picture/camera.h"

namespace lamella::picture {

// The corners around a vertex that belong to one sheet share one shaded vertex. A sheet ends at borders,
// rims, fixed lines and creases. Facets of a sheet may be wound against each other, as on a Moebius band;
// then the sheet has two shaded vertices with opposite normals, and each facet uses those on its own front.
struct Sheets {
  struct ShadedVertex {
    film::Vertex vertex;
    Point normal;  // of unit length, or zero where all facets are degenerate
  };
  std::vector<ShadedVertex> vertices;
  std::vector<std::uint32_t> of_corner;  // 3 a triangle row; no_index for tombstones
  std::vector<film::Edge> creases;       // edges inside a film at which it bends sharply
};

// `crease` is the angle, in degrees, between facets that are no longer shaded as one.
Sheets find_sheets(const film::Film& film, double crease);

}  // namespace lamella::picture
