#include "solve/basis.h"

#include <algorithm>

#include "scene/projection.h"

namespace lamella::solve {

Basis::Basis(const film::Film& film, std::span<const double> weights, MotionKind kind,
             const energy::VertexConstraints& constraints)
    : freedom_(film, kind), first_(film.vertex_rows() + 1) {
  std::uint32_t unknowns = 0;
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    first_[v] = unknowns;
    if (weights[v] == 0 || !film.first_end(film::Vertex(v)).valid()) continue;
    unknowns += constraints.holds(v) ? 3 : freedom_.count(v);
  }
  first_.back() = unknowns;
  direction_.resize(unknowns);
}

void Basis::renew(std::span<const Vec3> x, const energy::VertexConstraints& constraints) {
  freedom_.renew(x);
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    if (count(v) == 0) continue;
    if (constraints.holds(v)) {
      renew_held(v, constraints);
      continue;
    }
    const std::array<Vec3, 3> directions = freedom_.directions(v);
    for (std::uint32_t k = 0; k < count(v); ++k) direction_[first_[v] + k] = directions[k];
  }
}

// A rim slides in its constraint as its film's normal points there. On a border that lies in the constraint,
// the direction along it goes.
void Basis::renew_held(std::uint32_t v, const energy::VertexConstraints& constraints) {
  if (const auto normal = freedom_.sliding_normal(v)) {
    const Vec3 slide = constraints.restricted(v, *normal);
    if (squared_length(slide) > 1e-12) {
      direction_[first_[v]] = unit(slide);
      direction_[first_[v] + 1] = direction_[first_[v] + 2] = Vec3{};
      return;
    }
  }
  std::array<Vec3, 3> allowed;
  const int count = constraints.allowed(v, allowed);
  const Vec3 line = constraints.restricted(v, freedom_.along_line(v).value_or(Vec3{}));
  const bool slides = squared_length(line) > 0.5;
  std::vector<Vec3> span;
  if (slides) span.push_back(line);
  span.insert(span.end(), allowed.begin(), allowed.begin() + count);
  scene::orthonormalise(span);
  const std::size_t left = static_cast<std::size_t>(count) - (slides ? 1 : 0);
  for (std::size_t k = 0; k < 3; ++k)
    direction_[first_[v] + k] = k < left ? span[k + (slides ? 1 : 0)] : Vec3{};
}

std::size_t Basis::free_size() const {
  return static_cast<std::size_t>(
      std::count_if(direction_.begin(), direction_.end(), [](const Vec3& d) { return d != Vec3{}; }));
}

void Basis::expand(std::span<const double> reduced, std::span<Vec3> field) const {
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    Vec3 sum;
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) sum += reduced[i] * direction_[i];
    field[v] = sum;
  }
}

void Basis::reduce(std::span<const Vec3> field, std::span<double> reduced) const {
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) reduced[i] = dot(field[v], direction_[i]);
  }
}

}  // namespace lamella::solve
