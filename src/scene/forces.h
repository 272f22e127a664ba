// What acts on a film in motion besides its energy.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "language/formula.h"

namespace lamella::scene {

// A vector at each vertex: formulas in x, y, z, total_time, the scene's variables, the vertex's velocity vx,
// vy, vz, and its unit normal nx, ny, nz (out of the region of higher number, so out of a bubble; in films
// with one region on both sides its sign is arbitrary). They are to be bound (language::Formula::bind) before
// use.
struct VectorFormula {
  std::array<language::Formula, 3> component;
  std::string text() const {
    return component[0].text() + ", " + component[1].text() + ", " + component[2].text();
  }
};

// The names that VectorFormula reads besides coordinates and time, in this order.
inline const std::vector<std::string> vertex_state_names = {"vx", "vy", "vz", "nx", "ny", "nz"};

struct Forces {
  // Force per area of film: the acceleration, as the film's mass is its area.
  std::optional<VectorFormula> force;
  // Velocity of the air. It pushes the film along its normal: force per area = pressure (u.n) n with u the
  // air's velocity relative to the film; of bubbles only where the wind comes from outside.
  std::optional<VectorFormula> wind;
  double wind_pressure = 1;

  bool empty() const { return !force && !wind; }
};

}  // namespace lamella::scene
