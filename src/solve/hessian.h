// Exact second derivatives of a film's energy under its volume constraints, as one sparse matrix.
#pragma once

#include <span>
#include <vector>

#include "solve/basis.h"
#include "solve/problem.h"
#include "solve/sparse_factor.h"

namespace lamella::solve {

// The matrix of a Newton step, in the unknowns of a basis and a row for each volume constraint:
//
//   [ H + shift M   B ]    H: Hessian of energy - sum pressure * volume,   M: lumped mass (area) of the film,
//   [ B^T           0 ]    B: gradients of the volumes
//
// Both kinds of rows stand in one matrix so that one factorisation serves any number of bodies: fill-reducing
// orderings eliminate a body's dense row late by themselves, which for one body costs a solve, and for a
// thousand much less than as many right-hand sides would.
class ConstrainedHessian {
 public:
  // Finds the pattern for a compact film's present connectivity.
  ConstrainedHessian(const Problem& problem, const film::Film& film, const Basis& basis);

  std::size_t unknowns() const { return unknowns_; }
  std::size_t constraints() const { return constraints_; }

  // At the positions of the problem's last `linearise` and `descent_direction`, with its pressures; one pass
  // over the triangles.
  void assemble(const Problem& problem, const Basis& basis, std::span<const Vec3> x);
  // From the next `assemble` on, whether films have the Hessian of their Dirichlet energy in the place of
  // that of area and volumes. It is positive semidefinite and lies above the area's (no map has less
  // Dirichlet energy than area, and what stays has as much), so that a linearly implicit step stays stable
  // where triangles are drawn out; forces are not touched.
  void take_convex(bool convex) { convex_ = convex; }
  // Takes other masses than areas, one a vertex, before a shift is set; until the next `assemble`.
  void set_mass(std::span<const double> masses, const Basis& basis);
  // Sets the shift; 0 after `assemble`.
  void set_shift(double shift);
  double shift() const { return shift_; }

  const LowerMatrix& matrix() const { return matrix_; }
  // Of each unknown: a third of the area of the films around its vertex.
  std::span<const double> mass() const { return mass_; }
  // result = matrix times a vector: of the whole one, or of H + shift M alone if the vectors have only the
  // unknowns.
  void multiply(std::span<const double> vector, std::span<double> result) const;

 private:
  struct Pair {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    int entry = 0;
  };

  void build_pattern(const Problem& problem, const film::Film& film, const Basis& basis);
  int entry_of(std::uint32_t u, std::uint32_t v) const;
  void add_quantities(const energy::FilmEnergy& energy, const Basis& basis, std::span<const Vec3> x,
                      std::span<const double> multipliers);
  void add_films(const energy::FilmEnergy& energy, const Basis& basis, std::span<const Vec3> x,
                 std::span<const double> pressure);
  void add_other_terms(const energy::FilmEnergy& energy, const Basis& basis, std::span<const Vec3> x,
                       std::span<const double> pressure);
  void add_fields(const energy::FilmEnergy& energy, const Basis& basis, std::span<const Vec3> x,
                  std::span<const double> pressure);
  void add_edge(const Basis& basis, film::Vertex from, film::Vertex to, double factor,
                const energy::EdgeHessian& h);
  void add_constraints(const Problem& problem, const Basis& basis, std::span<const Vec3> x);
  void add_borders(const Problem& problem, const Basis& basis);
  void add_own(const Basis& basis, std::uint32_t v, const film::Mat3& block);
  void add_closed_edge(const Basis& basis, std::uint32_t v, double mixed, const Vec3& n);
  void add_mixed(const Basis& basis, std::uint32_t u, std::uint32_t v, int entry, const film::Mat3& block);
  double& value(int entry) { return matrix_.value[static_cast<std::size_t>(entry)]; }
  int column(std::size_t unknown) const { return matrix_.column_start[unknown]; }

  std::size_t unknowns_ = 0;
  std::size_t constraints_ = 0;
  LowerMatrix matrix_;
  // Blocks of two vertices: the rows of the higher one in the first column of the lower one begin here. In
  // its k-th column they stand k places nearer to the column's start, whose own rows are fewer.
  std::vector<std::uint32_t> neighbours_start_;  // of each vertex, among its higher neighbours
  std::vector<std::uint32_t> neighbours_;
  std::vector<int> neighbour_entry_;
  std::vector<std::array<int, 3>> triangle_entry_;  // of corner k and the next
  std::vector<int> border_entry_;                   // in the order of VolumeGradient::for_each
  std::vector<double> mass_;
  double shift_ = 0;
  bool convex_ = false;
  std::vector<Vec3> unfolded_;  // positions in a periodic film, with those of images
};

}  // namespace lamella::solve
