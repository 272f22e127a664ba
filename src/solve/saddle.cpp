#include "solve/saddle.h"

#include <algorithm>
#include <cmath>

#include "solve/modes.h"
#include "solve/seek.h"

namespace lamella::solve {

namespace {

// Whole-film motions are at most six a piece and lie near zero: so many modes show a lower one among them.
constexpr int modes_looked_at = 8;
// The first trial moves no vertex by more than this part of the film's size.
constexpr double first_part = 0.02;

}  // namespace

Departure leave_saddle(NewtonSystem& system, std::span<Vec3> x, double longest, scene::Monitor& monitor) {
  Departure result;
  result.energy = system.problem().energy().value(x);
  const std::vector<Mode> modes = lowest_modes(system, modes_looked_at, monitor);
  const auto lowest =
      std::find_if(modes.begin(), modes.end(), [](const Mode& mode) { return mode.rigid_part < 0.5; });
  if (lowest == modes.end()) return result;
  result.known = true;
  result.value = lowest->value;
  if (!(lowest->value < 0)) return result;
  std::vector<Vec3> way(x.size());
  system.basis().expand(lowest->reduced, way);
  double farthest = 0;
  for (const Vec3& w : way) farthest = std::max(farthest, length(w));
  const double size = std::sqrt(1 / system.scale());
  const double first = std::min(longest, first_part * size / farthest);
  const SeekResult found = seek_lowest(system.problem(), x, way, first, longest);
  result.moved = found.moved;
  result.energy = found.energy;
  result.scale = found.scale;
  return result;
}

}  // namespace lamella::solve
