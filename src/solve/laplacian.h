// The cotangent Laplacian of a film, factorised: the metric in which minimising area is easy.
//
// For a film of any topology, borders and rims included, the stiffness L with x^T L x / 2 = Dirichlet's
// energy of x has off-diagonal entries -(tension/2) cot(angle) summed over the triangles at an edge. The
// gradient of area at x is L(x) x, so L is the Hessian's leading part (U. Pinkall, K. Polthier, "Computing
// Discrete Minimal Surfaces and Their Conjugates", Experimental Mathematics 2, 1993), and iteration counts of
// a descent preconditioned by it do not grow with refinement.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "film/film.h"
#include "scene/scene.h"
#include "solve/metric.h"
#include "solve/sparse_factor.h"

namespace lamella::solve {

using film::Vec3;

// On the vertices that may move; the others are held at zero.
class Laplacian : public Metric {
 public:
  // Finds the pattern and the ordering for a compact film's present connectivity.
  Laplacian(const scene::Scene& scene, std::span<const double> weights);

  // Assembles and factorises at x. A film without any fixed vertex has a singular L (it may move freely), so
  // a part of the mass matrix is added; obtuse triangles with their negative weights are tamed. False if not
  // positive definite.
  bool factorise(std::span<const Vec3> x) override;

  // field = L^-1 field, each axis by itself; zero at held vertices.
  void solve(std::span<Vec3> field) override;

 private:
  film::Film film_;
  std::vector<double> tension_;
  std::vector<int> row_of_vertex_;  // -1 for held vertices
  std::vector<std::uint32_t> vertex_of_row_;
  std::vector<int> entry_of_edge_;  // in matrix_.value, -1 if an end is held
  LowerMatrix matrix_;
  std::unique_ptr<SparseFactor> factor_;
  std::vector<double> edge_weight_;
  std::vector<double> mass_;
  std::vector<double> right_;
  double shift_ = 0;
};

}  // namespace lamella::solve
