// Uniform refinement: every edge halved, every facet cut into four.
#pragma once

#include <cstdint>
#include <span>

#include "film/film.h"

namespace lamella::surgery {

struct RefineCounts {
  std::uint32_t edges = 0;   // edges halved
  std::uint32_t facets = 0;  // facets cut
};

// Halves every edge at its midpoint, except edges flagged `no_refine`, and cuts each facet to match: into
// four where all three edges are halved, three or two where some are not. New elements inherit by the rules
// of each column.
//
// Numbers follow Surface Evolver's: with V vertices and E edges before, the midpoint of the i-th halved edge
// is vertex V+i; the edge keeps its number for the half at its tail and the half at its head is edge E+i;
// then three inner edges a facet; the facet keeps its number for the inner triangle, and three corner
// triangles a facet follow.
//
// The film must be compact, and is compact afterwards; its elements are numbered anew by rows.
RefineCounts refine(film::Film& film);
// The same for chosen edges: those of the rows whose flag is not 0.
RefineCounts refine(film::Film& film, std::span<const std::uint8_t> halve);

}  // namespace lamella::surgery
