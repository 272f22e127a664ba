// The unknowns of a Newton step: for each vertex an orthonormal set of the directions in which it may move.
#pragma once

#include <span>
#include <vector>

#include "energy/vertex_constraints.h"
#include "solve/freedom.h"

namespace lamella::solve {

// Reduced vectors have one number for each direction of each vertex, in the order of the vertices: along
// normals that is one inside a film, two on a line, three at a corner, none for a vertex held fixed. How many
// directions a vertex has stays for the life of a basis; what they are is renewed with the positions.
class Basis {
 public:
  // `weights` as in Problem: 0 for what may not move. Isolated vertices are left out too. A vertex that
  // constraints hold has three places for directions, those it may not take being zero: one-sided constraints
  // come and go.
  Basis(const film::Film& film, std::span<const double> weights, MotionKind kind,
        const energy::VertexConstraints& constraints);
  // The constraints as they were last renewed.
  void renew(std::span<const Vec3> x, const energy::VertexConstraints& constraints);

  std::size_t vertex_count() const { return first_.size() - 1; }
  std::size_t size() const { return direction_.size(); }
  // The unknowns of vertex v are first(v), ..., first(v + 1) - 1.
  std::uint32_t first(std::size_t vertex) const { return first_[vertex]; }
  std::uint32_t count(std::size_t vertex) const { return first_[vertex + 1] - first_[vertex]; }
  // How many of the directions are not zero.
  std::size_t free_size() const;
  const Vec3& direction(std::size_t unknown) const { return direction_[unknown]; }

  // field = sum of directions times a reduced vector; zero at held vertices.
  void expand(std::span<const double> reduced, std::span<Vec3> field) const;
  // reduced = products of a field with the directions.
  void reduce(std::span<const Vec3> field, std::span<double> reduced) const;

 private:
  void renew_held(std::uint32_t v, const energy::VertexConstraints& constraints);

  Freedom freedom_;
  std::vector<std::uint32_t> first_;
  std::vector<Vec3> direction_;
};

}  // namespace lamella::solve
