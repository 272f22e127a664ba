#include "solve/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "film/union_find.h"

namespace lamella::solve {

namespace {

constexpr std::size_t most_pieces = 8;
// How far pieces are moved on trial: parts of a radian, or of the film's extent.
constexpr double trial = 0.3;
constexpr double same = 1e-10;  // relative
// A field counts as smooth if its curvature is below this part of what its diagonal terms alone would give.
constexpr double smooth = 0.05;
// A field whose part along the basis is shorter than this, or that the others span up to this, is dropped:
// a sphere that turns does not move.
constexpr double least_part = 1e-2;

using Reduced = std::vector<double>;

// The pieces of a film, as lists of vertices; empty if there are too many.
std::vector<std::vector<std::uint32_t>> pieces_of(const film::Film& film) {
  film::UnionFind sets(film.vertex_rows());
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e)
    sets.join(film.ends(film::Edge(e))[0].index, film.ends(film::Edge(e))[1].index);
  std::vector<std::vector<std::uint32_t>> pieces;
  std::vector<std::size_t> piece_of(film.vertex_rows(), SIZE_MAX);
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    if (!film.first_end(film::Vertex(v)).valid()) continue;
    std::size_t& piece = piece_of[sets.find(v)];
    if (piece == SIZE_MAX) {
      if (pieces.size() == most_pieces) return {};
      piece = pieces.size();
      pieces.emplace_back();
    }
    pieces[piece].push_back(v);
  }
  return pieces;
}

// Velocity and finite motion of one kind: 0 to 2 along an axis, 3 to 5 about one through the centre.
struct Motion {
  int kind = 0;
  Vec3 centre;
  double extent = 0;

  Vec3 axis() const {
    return {kind % 3 == 0 ? 1.0 : 0.0, kind % 3 == 1 ? 1.0 : 0.0, kind % 3 == 2 ? 1.0 : 0.0};
  }
  Vec3 velocity(const Vec3& p) const { return kind < 3 ? extent * axis() : cross(axis(), p - centre); }
  Vec3 moved(const Vec3& p) const {
    if (kind < 3) return p + trial * extent * axis();
    const Vec3 r = p - centre;
    return centre + std::cos(trial) * r + std::sin(trial) * cross(axis(), r) +
           (1 - std::cos(trial)) * dot(axis(), r) * axis();
  }
};

double extent_of(std::span<const Vec3> x, const std::vector<std::uint32_t>& piece, Vec3& centre) {
  centre = {};
  for (const std::uint32_t v : piece) centre += x[v] / static_cast<double>(piece.size());
  double extent = 0;
  for (const std::uint32_t v : piece) extent = std::max(extent, length(x[v] - centre));
  return extent;
}

bool is_symmetry(Problem& problem, std::span<const Vec3> x, const std::vector<std::uint32_t>& piece,
                 const Motion& motion) {
  std::vector<Vec3> moved(x.begin(), x.end());
  for (const std::uint32_t v : piece) {
    moved[v] = motion.moved(x[v]);
    if (!problem.movable(v) && length(moved[v] - x[v]) > same * motion.extent) return false;
  }
  if (!problem.energy().constraints().empty() &&
      problem.energy().constraints().violation(moved) > same * motion.extent)
    return false;
  const double energy = problem.energy().value(x);
  const std::vector<double> held(problem.energy().held_values().begin(),
                                 problem.energy().held_values().end());
  if (!(std::abs(problem.energy().value(moved) - energy) < same * std::abs(energy))) return false;
  const std::size_t bodies = problem.energy().constrained().size();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const double size = i < bodies ? std::abs(held[i]) : problem.energy().size_of_fixed(i - bodies, x);
    if (!(std::abs(problem.energy().held_values()[i] - held[i]) < same * size)) return false;
  }
  return true;
}

double mass_product(const ConstrainedHessian& hessian, const Reduced& a, const Reduced& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += hessian.mass()[i] * a[i] * b[i];
  return sum;
}

bool is_smooth(const ConstrainedHessian& hessian, const Reduced& field) {
  Reduced image(field.size());
  hessian.multiply(field, image);
  double curvature = 0;
  double rough = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto diagonal = static_cast<std::size_t>(hessian.matrix().column_start[i]);
    curvature += field[i] * image[i];
    rough += field[i] * field[i] * std::abs(hessian.matrix().value[diagonal]);
  }
  return std::abs(curvature) < smooth * rough;
}

}  // namespace

std::vector<std::vector<double>> rigid_motions(Problem& problem, const film::Film& film, const Basis& basis,
                                               const ConstrainedHessian& hessian, std::span<const Vec3> x) {
  std::vector<Reduced> fields;
  std::vector<Vec3> velocity(basis.vertex_count());
  for (const std::vector<std::uint32_t>& piece : pieces_of(film)) {
    Motion motion;
    motion.extent = extent_of(x, piece, motion.centre);
    if (!(motion.extent > 0)) continue;
    for (motion.kind = 0; motion.kind < 6; ++motion.kind) {
      if (!is_symmetry(problem, x, piece, motion)) continue;
      std::fill(velocity.begin(), velocity.end(), Vec3{});
      double whole = 0;
      for (const std::uint32_t v : piece) {
        velocity[v] = motion.velocity(x[v]);
        if (basis.count(v) > 0) whole += hessian.mass()[basis.first(v)] * squared_length(velocity[v]);
      }
      Reduced field(basis.size());
      basis.reduce(velocity, field);
      for (const Reduced& other : fields) {
        const double part = mass_product(hessian, field, other);
        for (std::size_t i = 0; i < field.size(); ++i) field[i] -= part * other[i];
      }
      const double squared = mass_product(hessian, field, field);
      if (!(squared > least_part * whole) || !is_smooth(hessian, field)) continue;
      for (double& f : field) f /= std::sqrt(squared);
      fields.push_back(std::move(field));
    }
  }
  return fields;
}

}  // namespace lamella::solve
