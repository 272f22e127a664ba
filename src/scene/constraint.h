// What holds vertices to surfaces and curves: level-set constraints and parametric boundaries.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "language/formula.h"

namespace lamella::scene {

// Which side of the level set a vertex may be on.
enum class Sense : std::uint8_t { equal, nonnegative, nonpositive };

// A vector field to be integrated along edges (in their own direction).
using EdgeIntegrand = std::array<language::Formula, 3>;

// CONSTRAINT in a datafile: vertices with formula = 0 (or >= 0, <= 0). Edges on it may carry an energy and
// add to the volumes of the bodies of their facets; both stand for facets that are left out, such as a wetted
// wall.
struct LevelSet {
  std::string name;  // empty for a numbered one
  language::Formula formula;
  Sense sense = Sense::equal;
  bool global = false;   // applies to every vertex
  bool convex = false;   // edges have a gap energy
  bool nonwall = false;  // popping takes no notice of it
  std::optional<EdgeIntegrand> energy;
  std::optional<EdgeIntegrand> content;
};

// BOUNDARY in a datafile: a curve (one parameter) or a surface (two) that vertices ride on by their
// parameters.
struct Boundary {
  std::string name;
  int parameters = 1;
  std::array<language::Formula, 3> position;  // of p1, p2, p3
  bool convex = false;
  std::optional<EdgeIntegrand> energy;
  std::optional<EdgeIntegrand> content;
};

using LevelSets = std::map<int, LevelSet>;
using Boundaries = std::map<int, Boundary>;

// --- how a film remembers them, as columns
// "constraint": integers, as many in a row as the widest set of the scene needs; numbers of constraints, 0
// for none. On edges a negative number turns the direction of integration around. New vertices and edges take
// their parent's.
inline constexpr const char* constraint_column = "constraint";
// "boundary": the number of a boundary, 0 for none.
inline constexpr const char* boundary_column = "boundary";
// "boundary_parameters": of a vertex on a boundary, three reals.
inline constexpr const char* parameter_column = "boundary_parameters";

}  // namespace lamella::scene
