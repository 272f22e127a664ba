// How far a film is from Plateau's laws: three films meet at 120 degrees along a border, four borders at
// arccos(-1/3) = 109.4712 degrees in a quad point.
#pragma once

#include <cstddef>

#include "film/film.h"

namespace lamella::energy {

// Deviations in degrees.
struct AngleDeviation {
  std::size_t angles = 0;
  double rms = 0;
  double worst = 0;
};

struct PlateauAngles {
  AngleDeviation triple;          // dihedral angles between neighbouring films around borders of three films
  AngleDeviation quad;            // angles between the borders at vertices where four meet
  std::size_t other_borders = 0;  // edges of more than three films: unstable
  std::size_t other_points =
      0;  // vertices where three or more borders meet, but not four of three films each
};

// Border edges with both ends fixed and fixed vertices are left out: wires hold films at any angle.
PlateauAngles plateau_angles(const film::Film& film);

}  // namespace lamella::energy
