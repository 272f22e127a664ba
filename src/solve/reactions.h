// What a film pulls on: wires, boundaries and constraints.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace lamella::solve {

enum class Holder : std::uint8_t { boundary, constraints, wire };

struct Reaction {
  Holder holder = Holder::wire;
  std::vector<int> numbers;  // of the boundary, or of the constraints that hold the same vertices together
  film::Vertex first;        // the lowest of its vertices
  std::uint32_t vertices = 0;
  film::Vec3 pull;  // of the film on the holder
};

// The film's forces on what holds it, pressures and other multipliers being such as leave the smallest forces
// elsewhere: boundaries and constraints by their numbers, then wires by their vertices. A fixed vertex on a
// boundary counts with that; other fixed vertices make up wires, as far as edges between them reach. Vertices
// that slide count with the part of the force that they do not give way to. Nothing if the forces are not
// finite.
std::optional<std::vector<Reaction>> reactions(const scene::Scene& scene);

}  // namespace lamella::solve
