// The vertices that level sets and boundaries hold, and the motions they leave them.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "film/mat3.h"
#include "scene/scene.h"

namespace lamella::energy {

using film::Vec3;

// A scene without constraints has none of this: `empty` is all that is asked.
class VertexConstraints {
 public:
  // Formulas are bound to the scene's present variables; its time is the one at which they are evaluated.
  VertexConstraints() = default;
  explicit VertexConstraints(const scene::Scene& scene);

  bool empty() const { return held_.empty() && single_vertices_.empty(); }
  // Whether one-sided constraints held some vertex when they were last renewed.
  bool touched() const { return touched_; }
  // Whether some formula depends on the time.
  bool moves() const { return moves_; }
  // Whether a vertex is held.
  bool holds(std::uint32_t vertex) const { return !index_.empty() && index_[vertex] != none; }
  // Formulas that depend on time are evaluated at this time from now on.
  void set_time(double time) { scene_.time = time; }
  // Formulas are bound to these variables from now on.
  void set_variables(const language::Variables& variables);

  // The directions left at x. One-sided constraints hold where the vertex is on (or beyond) the level and
  // `force` (a row a vertex, may be empty: all of them hold) pushes it outward.
  void renew(std::span<const Vec3> x, std::span<const Vec3> force = {});
  // Takes out of a vector at a vertex what its constraints forbid.
  Vec3 restricted(std::uint32_t vertex, const Vec3& vector) const {
    if (!holds(vertex)) return vector;
    const std::uint32_t row = index_[vertex];
    if (row < held_.size()) return restricted_by(held_[row], vector);
    const Vec3& normal = single_normals_[row - held_.size()];
    return vector - dot(vector, normal) * normal;
  }
  void restrict(std::span<Vec3> field) const;

  // An orthonormal set of the directions left to a held vertex; returns how many.
  int allowed(std::uint32_t vertex, std::array<Vec3, 3>& directions) const;

  // What constraints add to second derivatives at a held vertex: a vertex that moves within them by u moves
  // across them by a term of second order, against which `force` (minus the gradient, unrestricted) works.
  // The block B of the second variation u . B u, for u among the directions allowed.
  film::Mat3 curvature(std::uint32_t vertex, const Vec3& at, const Vec3& force) const;

  // Puts the held vertices of x onto their constraints. A fixed vertex on a boundary goes where its
  // parameters are now (a boundary may move in time). One on a level set stays, unless the level depends on a
  // parameter that is optimized. False if one of them cannot be put there.
  bool project(std::span<Vec3> x);
  // The boundary parameters that belong to x after `project`, written to the scene.
  void publish(scene::Scene& scene) const;
  // The largest distance (to first order) of a vertex from a constraint that it violates.
  double violation(std::span<const Vec3> x) const;

  template <class Function>
  void for_each(Function&& function) const {
    for (const Held& held : held_) function(held.vertex);
    for (const std::uint32_t vertex : single_vertices_) function(vertex);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Held {
    std::uint32_t vertex = 0;
    int boundary = 0;
    bool fixed = false;  // on a boundary: the parameters stay; on level sets: the vertex stays, or follows
    bool follows = false;
    std::vector<int> level_sets;
    std::array<double, 3> parameters{};
    // Orthonormal: the directions forbidden (level sets) or the only ones allowed (boundaries).
    std::array<Vec3, 3> directions;
    int count = 0;
    std::array<int, 3> active{};  // the level sets that `directions` come from, before any was left out
    int active_count = 0;
  };
  // Vertices that one level set holds and nothing else, which is by far the commonest: a range of
  // `single_vertices_`, evaluated side by side.
  struct Group {
    int number = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  using Points = std::array<language::Lanes, 3>;
  void add_groups(std::vector<std::pair<int, std::uint32_t>>& singles);
  template <class Function>
  void for_each_block(const Group& group, std::span<const Vec3> x, Function&& function) const;
  bool project(const Group& group, std::span<Vec3> x) const;
  bool project_block(const scene::LevelSet& set, Points& points) const;
  void renew(const Group& group, std::span<const Vec3> x, std::span<const Vec3> force);
  const Group& group_of(std::size_t single) const;
  // The directions that level sets forbid at a vertex; returns how many.
  int forbidden(std::uint32_t row, std::array<Vec3, 3>& directions) const;
  film::Mat3 level_curvature(std::uint32_t vertex, std::span<const int> active, const Vec3& at,
                             const Vec3& force) const;
  film::Mat3 boundary_curvature(const Held& held, const Vec3& force) const;
  static Vec3 restricted_by(const Held& held, const Vec3& vector);
  void renew_levels(Held& held, const Vec3& at, const Vec3* force);
  void renew_boundary(Held& held, const Vec3& at);

  scene::Scene scene_;  // without its film's positions: constraints, variables, attributes, time
  // Of each vertex: its row in held_, or the size of held_ and its row among the single ones.
  std::vector<std::uint32_t> index_;
  std::vector<Held> held_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> single_vertices_;
  std::vector<Vec3> single_normals_;  // unit vectors; 0 where a one-sided level does not hold
  bool touched_ = false;
  bool moves_ = false;
};

}  // namespace lamella::energy
