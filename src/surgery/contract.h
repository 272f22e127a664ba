// A cluster of vertices that has come together seen as one point, and resolved into what lowers the energy
// most: the kernel of T1, T2, the closing of necks, and the popping of points that no film keeps.
//
// pick: the caller's cluster. rank: each rearrangement of its link is relaxed on a copy of the few facets
// around; so is the film as it is. check: the best must beat the film as it is (relaxed, too) by `gain`; no
// sliver, no facet that passes through another. commit: all of it or nothing.
#pragma once

#include <optional>
#include <span>

#include "film/crossing_grid.h"
#include "scene/scene.h"
#include "surgery/event.h"
#include "surgery/rearrangement.h"

namespace lamella::surgery {

struct ContractOptions {
  double size = 0;     // the length of edges aimed at around here
  double gain = 1e-3;  // least energy to be won, in units of tension times size^2; may be -infinity
  std::optional<Move> only = {};  // no other move
  // May be gone afterwards although it has a target volume; another may not.
  film::Region vanishes = film::outside_region;
  // For several contractions one after the other, with no other change in between: made where it is needed
  // first.
  std::optional<film::CrossingGrid>* grid = nullptr;
};

struct Contraction {
  Event event;
  double gain = 0;                 // of energy, in the trial
  std::vector<film::Vertex> made;  // the copies
};

// Nothing where no rearrangement is better, or the best cannot be made. The film is then as it was, to the
// bit. A cluster with a vertex that is held (fixed, on a constraint or boundary) is left alone, and so is
// every one of a periodic film.
std::optional<Contraction> contract(scene::Scene& scene, std::span<const film::Vertex> cluster,
                                    const ContractOptions& options);

// Whether nothing holds a vertex.
bool is_free(const scene::Scene& scene, film::Vertex v);

}  // namespace lamella::surgery
