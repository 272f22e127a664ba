// Points brought to surfaces and curves, and the directions they may move in there.
#pragma once

#include <span>

#include "scene/constraint_sets.h"

namespace lamella::scene {

// A level set as a vertex meets it.
struct Level {
  double value = 0;
  film::Vec3 gradient;
};

// Whether a vertex where the formula has this value must move: always, for an equality.
bool violated(const LevelSet& set, double value);

// The value and gradient of a formula at a point; attributes are those of the vertex (a row of the film).
Level level_at(const Scene& scene, const LevelSet& set, const film::Vec3& point, std::uint32_t vertex);

// The attributes that a formula reads, of one element.
std::vector<double> attributes_of(const film::Film& film, const language::Formula& formula,
                                  film::ElementKind kind, std::uint32_t row);

// The nearest point (to first order, by Newton's method with the smallest steps) at which all constraints
// hold: equalities exactly, one-sided ones if violated. Returns false if it does not converge: constraints
// that contradict each other, or a formula without value or gradient there. Values of formulas up to
// `tolerance` count as 0.
bool project_to_level_sets(const Scene& scene, std::span<const int> numbers, std::uint32_t vertex,
                           film::Vec3& point, double tolerance = 0);

// A point of a boundary with its derivatives by the parameters.
struct BoundaryPoint {
  film::Vec3 position;
  std::array<film::Vec3, 3> tangents;
};
BoundaryPoint boundary_point(const Scene& scene, const Boundary& boundary,
                             const std::array<double, 3>& parameters);

// Moves parameters towards the point of the boundary nearest to `target` by steps of Gauss and Newton's
// method. Returns the last change of a parameter, relative to its size; not a number where that leads
// nowhere.
double approach_parameters(const Scene& scene, const Boundary& boundary, const film::Vec3& target,
                           std::array<double, 3>& parameters, int steps);

// The same until nothing changes any more. False if it does not converge.
bool nearest_parameters(const Scene& scene, const Boundary& boundary, const film::Vec3& target,
                        std::array<double, 3>& parameters);

// Puts a vertex on its boundary (where its parameters are, or those of the point nearest to it) or else on
// its constraints, whose formulas must be bound. False if that does not converge.
bool constrain_vertex(Scene& scene, film::Vertex v, bool keep_parameters, double tolerance = 0);

// The part of a vector that up to three others span, as multiples of them (by least squares; 0 for one that
// depends on the others).
std::array<double, 3> shares(std::span<const film::Vec3> vectors, const film::Vec3& vector);

// An orthonormal set spanned by vectors, leaving out what depends on others; returns how many.
int orthonormalise(std::span<film::Vec3> vectors);

}  // namespace lamella::scene
