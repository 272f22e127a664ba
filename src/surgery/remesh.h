// A mesh brought back into its band of sizes and angles: long edges divided, short ones collapsed, flat
// triangles flipped, vertices evened out. What lies within the band is not touched at all.
#pragma once

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

struct RemeshOptions {
  double longest = 1.6;      // edges are divided above this, in units of the size (surgery/sizing.h)
  double shortest = 0.5;     // and collapse below this
  double flip_slack = 0.35;  // radians by which opposite angles may exceed a half turn
  double sliver = 0.15;      // facets lower than this, in units of their longest side, are mended
  double least_move = 0;     // in sizes, of a vertex that is evened out; of a film in motion little ones wait
  int rounds = 2;
};

struct RemeshReport {
  long splits = 0;
  long collapses = 0;
  long flips = 0;
  long moved = 0;
  // Where the topology of the film would have to change for the band to be kept: what is about to come
  // together, a cluster each.
  std::vector<std::vector<film::Vertex>> stuck;
  std::vector<film::Vertex> touched;  // some removed since; a few twice

  long operations() const { return splits + collapses + flips + moved; }
};

// Whether anything is out of the band.
bool needs_remesh(const film::Film& film, std::span<const film::Vec3> positions,
                  const RemeshOptions& options);

// The film keeps tombstones. Vertices made on curves are put there. Volumes change to second order.
RemeshReport remesh(scene::Scene& scene, const RemeshOptions& options);

}  // namespace lamella::surgery
