#include "solve/basis.h"

namespace lamella::solve {

Basis::Basis(const film::Film& film, std::span<const double> weights, MotionKind kind)
    : freedom_(film, kind), first_(film.vertex_rows() + 1) {
  std::uint32_t unknowns = 0;
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    first_[v] = unknowns;
    if (weights[v] != 0 && film.first_end(film::Vertex(v)).valid()) unknowns += freedom_.count(v);
  }
  first_.back() = unknowns;
  direction_.resize(unknowns);
}

void Basis::renew(std::span<const Vec3> x) {
  freedom_.renew(x);
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    if (count(v) == 0) continue;
    const std::array<Vec3, 3> directions = freedom_.directions(v);
    for (std::uint32_t k = 0; k < count(v); ++k) direction_[first_[v] + k] = directions[k];
  }
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
