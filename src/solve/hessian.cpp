#include "solve/hessian.h"

#include <algorithm>

#include "energy/triangle_hessian.h"

namespace lamella::solve {

namespace {

using film::Mat3;

constexpr double no_direction = 1e20;

constexpr std::size_t next_of(std::size_t corner) {
  return (corner + 1) % 3;
}

// Each vertex's neighbours of higher number, over edges and as far pairs have it, sorted, each once; vertices
// without unknowns are left out.
void collect_neighbours(const film::Film& film, std::span<const std::array<std::uint32_t, 2>> far_pairs,
                        const Basis& basis, std::vector<std::uint32_t>& start,
                        std::vector<std::uint32_t>& neighbours) {
  const std::size_t vertices = basis.vertex_count();
  start.assign(vertices + 1, 0);
  const auto each_edge = [&](auto&& function) {
    const auto pair = [&](std::uint32_t u, std::uint32_t v) {
      const auto [low, high] = std::minmax(u, v);
      if (low != high && basis.count(low) > 0 && basis.count(high) > 0) function(low, high);
    };
    for (std::uint32_t e = 0; e < film.edge_rows(); ++e)
      pair(film.ends(film::Edge(e))[0].index, film.ends(film::Edge(e))[1].index);
    for (const auto& [u, v] : far_pairs) pair(u, v);
  };
  each_edge([&](std::uint32_t low, std::uint32_t) { ++start[low + 1]; });
  for (std::size_t v = 0; v < vertices; ++v) start[v + 1] += start[v];
  neighbours.resize(start[vertices]);
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  each_edge([&](std::uint32_t low, std::uint32_t high) { neighbours[next[low]++] = high; });
  // Several edges between the same vertices share a block.
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto first = neighbours.begin() + start[v];
    const auto last = neighbours.begin() + next[v];
    std::sort(first, last);
    start[v] = kept;
    for (auto at = first; at != last; ++at) {
      if (at == first || *at != *(at - 1)) neighbours[kept++] = *at;
    }
  }
  start[vertices] = kept;
  neighbours.resize(kept);
}

// The pressure in each region, prescribed or of a constraint; what has neither has no part in the Lagrangian.
std::vector<double> pressures_of_regions(const Problem& problem) {
  const energy::FilmEnergy& energy = problem.energy();
  std::vector<double> pressure(energy.volumes().size());
  for (std::size_t i = 0; i < energy.pressurised().size(); ++i)
    pressure[energy.pressurised()[i].index] = energy.prescribed_pressures()[i];
  for (std::size_t i = 0; i < energy.constrained().size(); ++i)
    pressure[energy.constrained()[i].index] = problem.pressures()[i];
  return pressure;
}

}  // namespace

ConstrainedHessian::ConstrainedHessian(const Problem& problem, const film::Film& film, const Basis& basis)
    : unknowns_(basis.size()), constraints_(problem.constraint_count()), mass_(basis.size()) {
  build_pattern(problem, film, basis);
}

void ConstrainedHessian::build_pattern(const Problem& problem, const film::Film& film, const Basis& basis) {
  collect_neighbours(film, problem.energy().far_pairs(), basis, neighbours_start_, neighbours_);
  std::vector<std::uint32_t> bodies_at(basis.vertex_count());
  const energy::VolumeGradient& volume = problem.energy().volume_gradient();
  volume.for_each_entry([&](std::uint32_t v, int) { ++bodies_at[v]; });

  std::vector<int>& start = matrix_.column_start;
  start.assign(unknowns_ + constraints_ + 1, 0);
  std::vector<std::uint32_t> around(basis.vertex_count());  // rows of the neighbours in each of its columns
  for (std::size_t v = 0; v < basis.vertex_count(); ++v) {
    for (std::uint32_t i = neighbours_start_[v]; i < neighbours_start_[v + 1]; ++i)
      around[v] += basis.count(neighbours_[i]);
    for (std::uint32_t k = 0; k < basis.count(v); ++k)
      start[basis.first(v) + k + 1] = static_cast<int>(basis.count(v) - k + around[v] + bodies_at[v]);
  }
  for (std::size_t i = 0; i < constraints_; ++i) start[unknowns_ + i + 1] = 1;
  for (std::size_t i = 0; i + 1 < start.size(); ++i) start[i + 1] += start[i];
  matrix_.row.resize(static_cast<std::size_t>(start.back()));
  matrix_.value.resize(matrix_.row.size());

  neighbour_entry_.resize(neighbours_.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  const auto put = [&](std::size_t at, std::size_t row) {
    matrix_.row[static_cast<std::size_t>(next[at]++)] = static_cast<int>(row);
  };
  for (std::size_t v = 0; v < basis.vertex_count(); ++v) {
    for (std::uint32_t k = 0; k < basis.count(v); ++k) {
      const std::size_t at = basis.first(v) + k;
      for (std::size_t row = at; row < basis.first(v + 1); ++row) put(at, row);
      for (std::uint32_t i = neighbours_start_[v]; i < neighbours_start_[v + 1]; ++i) {
        const std::uint32_t high = neighbours_[i];
        if (k == 0) neighbour_entry_[i] = next[at];
        for (std::size_t row = basis.first(high); row < basis.first(high + 1); ++row) put(at, row);
      }
    }
  }
  volume.for_each_entry([&](std::uint32_t v, int body) {
    for (std::size_t at = basis.first(v); at < basis.first(v + 1); ++at) {
      border_entry_.push_back(next[at]);
      put(at, unknowns_ + static_cast<std::size_t>(body));
    }
  });
  for (std::size_t i = 0; i < constraints_; ++i) put(unknowns_ + i, unknowns_ + i);

  const auto& triangles = film.connectivity().triangle_vertices;
  triangle_entry_.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k)
      triangle_entry_[t][k] = entry_of(triangles[t][k].index, triangles[t][next_of(k)].index);
  }
}

// -1 if one of them has no unknowns.
int ConstrainedHessian::entry_of(std::uint32_t u, std::uint32_t v) const {
  const auto [low, high] = std::minmax(u, v);
  const auto first = neighbours_.begin() + neighbours_start_[low];
  const auto last = neighbours_.begin() + neighbours_start_[low + 1];
  const auto at = std::lower_bound(first, last, high);
  if (at == last || *at != high) return -1;
  return neighbour_entry_[static_cast<std::size_t>(at - neighbours_.begin())];
}

void ConstrainedHessian::assemble(const Problem& problem, const Basis& basis, std::span<const Vec3> x) {
  std::fill(matrix_.value.begin(), matrix_.value.end(), 0.0);
  shift_ = 0;
  const std::vector<double> pressure = pressures_of_regions(problem);
  const film::Unfolding& unfolding = problem.energy().unfolding();
  const std::span<const Vec3> rows = unfolding.empty() ? x : unfolding.extend(x, unfolded_);
  add_quantities(problem.energy(), basis, rows, problem.pressures());
  add_films(problem.energy(), basis, rows, pressure);
  add_other_terms(problem.energy(), basis, rows, pressure);
  add_fields(problem.energy(), basis, x, pressure);
  add_constraints(problem, basis, x);
  add_borders(problem, basis);
  const std::span<const energy::VertexLine> lines = problem.energy().lines();
  double total = 0;
  for (const energy::VertexLine& line : lines) total += line.area;
  const double least = total > 0 ? 1e-6 * total / static_cast<double>(lines.size()) : 1;
  for (std::size_t v = 0; v < basis.vertex_count(); ++v) {
    for (std::size_t i = basis.first(v); i < basis.first(v + 1); ++i) {
      mass_[i] = std::max(lines[v].area, least);
      // What nothing pulls at stays where it is. A direction that is none lies above all modes.
      if (value(column(i)) == 0) value(column(i)) = basis.direction(i) == Vec3{} ? no_direction : 1;
    }
  }
}

void ConstrainedHessian::add_quantities(const energy::FilmEnergy& energy, const Basis& basis,
                                        std::span<const Vec3> x, std::span<const double> multipliers) {
  class Sink : public energy::HessianSink {
   public:
    Sink(ConstrainedHessian& hessian, const film::Unfolding& unfolding, const Basis& basis)
        : hessian_(hessian), unfolding_(unfolding), basis_(basis) {}
    void add(std::uint32_t first, std::uint32_t second, const Mat3& block) override {
      const std::uint32_t u = row(first);
      const std::uint32_t v = row(second);
      if (first == second) return hessian_.add_own(basis_, u, block);
      hessian_.add_mixed(basis_, u, v, hessian_.entry_of(u, v), block);
    }

   private:
    std::uint32_t row(std::uint32_t of) const {
      return unfolding_.empty() ? of : unfolding_.vertex_of(film::Vertex(of)).index;
    }
    ConstrainedHessian& hessian_;
    const film::Unfolding& unfolding_;
    const Basis& basis_;
  };
  Sink sink(*this, energy.unfolding(), basis);
  energy.add_quantity_hessians(x, multipliers, sink);
}

// The blocks of energy/triangle_hessian.h, with d the directions of corners i and j, the normal n and
// w = pressure/6 (third corner) - tension/2 n:  s (e_i . e_j)(n . d_i)(n . d_j) + w . (d_j x d_i).
// Those of the Dirichlet energy:  s (e_i . e_j)(d_i . d_j).
void ConstrainedHessian::add_films(const energy::FilmEnergy& energy, const Basis& basis,
                                   std::span<const Vec3> x, std::span<const double> pressure) {
  const energy::SweepInput& input = energy.input();
  const bool periodic = !energy.unfolding().empty();
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    const auto& corner = input.triangles[t];
    const std::array<Vec3, 3> p{x[corner[0].index], x[corner[1].index], x[corner[2].index]};
    const auto& v = periodic ? energy.vertices(t) : corner;
    const double tension = input.tension.empty() ? 1.0 : input.tension[t];
    const double push =
        (pressure[input.regions[t].behind.index] - pressure[input.regions[t].front.index]) / 6;
    const Vec3 doubled = energy::double_area_vector(p[0], p[1], p[2]);
    const double size = length(doubled);
    const double inverse = size > 0 ? 1 / size : 0;
    const Vec3 n = inverse * doubled;
    const double s = 0.5 * tension * inverse;
    const std::array<Vec3, 3> e{p[2] - p[1], p[0] - p[2], p[1] - p[0]};
    const auto product = [&](const Vec3& a, const Vec3& b) {
      return convex_ ? dot(a, b) : dot(n, a) * dot(n, b);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = next_of(i);
      const std::uint32_t first = basis.first(v[i].index);
      const std::uint32_t own = basis.first(v[i].index + 1) - first;
      const double square = s * dot(e[i], e[i]);
      for (std::uint32_t k = 0; k < own; ++k) {
        const Vec3& dk = basis.direction(first + k);
        for (std::uint32_t l = k; l < own; ++l)
          value(column(first + k) + static_cast<int>(l - k)) +=
              square * product(dk, basis.direction(first + l));
      }
      const int entry = triangle_entry_[t][i];
      if (entry < 0) {
        if (v[i] == v[j]) add_closed_edge(basis, v[i].index, s * dot(e[i], e[j]), n);
        continue;
      }
      const std::uint32_t other = basis.first(v[j].index);
      const std::uint32_t others = basis.first(v[j].index + 1) - other;
      const double mixed = s * dot(e[i], e[j]);
      // Seen from the edge itself, or neighbours that lie in different cells would not agree.
      const Vec3 origin = periodic ? 0.5 * (p[i] + p[j]) : input.origin;
      const Vec3 w = convex_ ? Vec3{} : push * (p[next_of(j)] - origin) - (0.5 * tension) * n;
      for (std::uint32_t k = 0; k < own; ++k) {
        const Vec3& di = basis.direction(first + k);
        for (std::uint32_t l = 0; l < others; ++l) {
          const Vec3& dj = basis.direction(other + l);
          const double h = mixed * product(di, dj) + dot(w, cross(dj, di));
          if (first < other) {
            value(entry + column(first + k) - column(first) - static_cast<int>(k) + static_cast<int>(l)) += h;
          } else {
            value(entry + column(other + l) - column(other) - static_cast<int>(l) + static_cast<int>(k)) += h;
          }
        }
      }
    }
  }
}

// The mixed block of an edge from a vertex to its own image, with its transpose: what is skew in it cancels.
void ConstrainedHessian::add_closed_edge(const Basis& basis, std::uint32_t v, double mixed, const Vec3& n) {
  for (std::uint32_t k = basis.first(v); k < basis.first(v + 1); ++k) {
    const Vec3& dk = basis.direction(k);
    for (std::uint32_t l = k; l < basis.first(v + 1); ++l) {
      const Vec3& dl = basis.direction(l);
      value(column(k) + static_cast<int>(l - k)) += 2 * mixed * dot(n, dk) * dot(n, dl);
    }
  }
}

void ConstrainedHessian::add_own(const Basis& basis, std::uint32_t v, const Mat3& block) {
  for (std::uint32_t k = basis.first(v); k < basis.first(v + 1); ++k) {
    const Vec3 image = block * basis.direction(k);
    for (std::uint32_t l = k; l < basis.first(v + 1); ++l)
      value(column(k) + static_cast<int>(l - k)) += dot(basis.direction(l), image);
  }
}

// block = d2/d(u)d(v)
void ConstrainedHessian::add_mixed(const Basis& basis, std::uint32_t u, std::uint32_t v, int entry,
                                   const Mat3& block) {
  if (u == v) return add_own(basis, u, block + transposed(block));
  if (entry < 0) return;
  if (v < u) return add_mixed(basis, v, u, entry, transposed(block));
  const std::uint32_t first = basis.first(u);
  for (std::uint32_t k = 0; k < basis.count(u); ++k) {
    const int at = entry + column(first + k) - column(first) - static_cast<int>(k);
    for (std::uint32_t l = 0; l < basis.count(v); ++l)
      value(at + static_cast<int>(l)) +=
          dot(basis.direction(first + k), block * basis.direction(basis.first(v) + l));
  }
}

void ConstrainedHessian::add_other_terms(const energy::FilmEnergy& energy, const Basis& basis,
                                         std::span<const Vec3> x, std::span<const double> pressure) {
  const energy::SweepInput& input = energy.input();
  for (const energy::HeavyFacet& facet : energy.heavy()) {
    const auto& corner = input.triangles[facet.triangle];
    const energy::TriangleHessian h =
        energy::height_integral_hessian(x[corner[0].index], x[corner[1].index], x[corner[2].index]);
    const auto& v = energy.vertices(facet.triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = next_of(k);
      add_own(basis, v[k].index, facet.weight * h[k][k]);
      add_mixed(basis, v[k].index, v[j].index, triangle_entry_[facet.triangle][k], facet.weight * h[k][j]);
    }
  }
  for (const energy::FilmEnergy::TenseEdge& edge : energy.tense_edges()) {
    const Mat3 h = edge.tension * energy::edge_length_hessian(x[edge.tail.index], x[edge.head.index]);
    const std::uint32_t tail = energy.vertex_of(edge.tail).index;
    const std::uint32_t head = energy.vertex_of(edge.head).index;
    add_own(basis, tail, h);
    add_own(basis, head, h);
    add_mixed(basis, tail, head, entry_of(tail, head), -1 * h);
  }
  for (const energy::RimEdge& rim : energy.rims()) {
    const double factor = -pressure[rim.region.index] * rim.times;
    if (factor == 0) continue;
    const energy::RimHessian h =
        rim_volume_hessian(x[rim.from.index], x[rim.to.index], input.origin, energy.open_volume());
    add_own(basis, rim.from.index, factor * h.from_from);
    add_own(basis, rim.to.index, factor * h.to_to);
    add_mixed(basis, rim.from.index, rim.to.index, entry_of(rim.from.index, rim.to.index),
              factor * h.from_to);
  }
}

void ConstrainedHessian::add_edge(const Basis& basis, film::Vertex from, film::Vertex to, double factor,
                                  const energy::EdgeHessian& h) {
  add_own(basis, from.index, factor * h.from_from);
  add_own(basis, to.index, factor * h.to_to);
  add_mixed(basis, from.index, to.index, entry_of(from.index, to.index), factor * h.from_to);
}

// Energies and contents along edges on constraints.
void ConstrainedHessian::add_fields(const energy::FilmEnergy& energy, const Basis& basis,
                                    std::span<const Vec3> x, std::span<const double> pressure) {
  const auto integral = [&](const energy::FieldEdge& edge, double factor) {
    if (factor == 0) return;
    add_edge(basis, edge.from, edge.to, factor,
             energy::edge_integral_hessian(edge, x, energy.time(), energy.edge_integral_order()));
  };
  for (const energy::FieldEdge& edge : energy.energy_edges()) integral(edge, 1);
  for (const energy::FieldEdge& edge : energy.content_edges()) integral(edge, -pressure[edge.region.index]);
  for (const energy::GapEdge& gap : energy.gaps()) {
    add_edge(basis, gap.tail, gap.head, energy.gap_constant(),
             energy::gap_hessian(gap, x[gap.tail.index], x[gap.head.index], energy.time()));
  }
  for (const energy::BoundaryGapEdge& gap : energy.boundary_gaps()) {
    add_edge(basis, gap.tail, gap.head, energy.gap_constant(),
             energy::boundary_gap_hessian(energy.scene(), gap, x[gap.tail.index], x[gap.head.index]));
  }
}

void ConstrainedHessian::add_constraints(const Problem& problem, const Basis& basis,
                                         std::span<const Vec3> x) {
  const energy::VertexConstraints& constraints = problem.energy().constraints();
  constraints.for_each([&](std::uint32_t v) {
    if (basis.count(v) > 0) add_own(basis, v, constraints.curvature(v, x[v], problem.force(v)));
  });
}

// A body that nothing can move gets a pivot of its own: its multiplier is then 0.
void ConstrainedHessian::add_borders(const Problem& problem, const Basis& basis) {
  std::vector<double> squared(constraints_);
  std::size_t at = 0;
  problem.energy().volume_gradient().for_each([&](std::uint32_t v, int body, const Vec3& gradient) {
    for (std::size_t i = basis.first(v); i < basis.first(v + 1); ++i) {
      const double product = dot(gradient, basis.direction(i));
      value(border_entry_[at++]) = product;
      squared[static_cast<std::size_t>(body)] += product * product;
    }
  });
  for (std::size_t i = 0; i < constraints_; ++i) value(column(unknowns_ + i)) = squared[i] > 0 ? 0 : -1;
}

void ConstrainedHessian::set_mass(std::span<const double> masses, const Basis& basis) {
  for (std::size_t v = 0; v < masses.size(); ++v) {
    for (std::size_t i = basis.first(v); i < basis.first(v + 1); ++i) mass_[i] = masses[v];
  }
}

void ConstrainedHessian::set_shift(double shift) {
  for (std::size_t i = 0; i < unknowns_; ++i) value(column(i)) += (shift - shift_) * mass_[i];
  shift_ = shift;
}

void ConstrainedHessian::multiply(std::span<const double> vector, std::span<double> result) const {
  std::fill(result.begin(), result.end(), 0.0);
  for (std::size_t j = 0; j < vector.size(); ++j) {
    const auto first = static_cast<std::size_t>(column(j));
    const auto last = static_cast<std::size_t>(column(j + 1));
    double sum = matrix_.value[first] * vector[j];
    for (std::size_t at = first + 1; at < last; ++at) {
      const auto i = static_cast<std::size_t>(matrix_.row[at]);
      if (i >= vector.size()) break;  // constraints stand last
      sum += matrix_.value[at] * vector[i];
      result[i] += matrix_.value[at] * vector[j];
    }
    result[j] += sum;
  }
}

}  // namespace lamella::solve
