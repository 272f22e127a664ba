// The band of facets between two lines that has the least area.
#pragma once

#include <array>
#include <vector>

#include "film/film.h"

namespace lamella::surgery {

struct Strip {
  std::vector<std::array<film::Vertex, 3>> facets;
  double area = 0;
};

// Both loops turn alike; the facets turn along the outer loop and against the inner one.
Strip strip_between_loops(const film::Film& film, std::vector<film::Vertex> inner,
                          std::vector<film::Vertex> outer);

// Both lines run from one common end to the other.
Strip strip_between_lines(const film::Film& film, const std::vector<film::Vertex>& inner,
                          const std::vector<film::Vertex>& outer);

}  // namespace lamella::surgery
