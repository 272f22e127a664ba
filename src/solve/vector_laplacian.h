// The Laplacian of a film whose vertices are held to surfaces and curves.
#pragma once

#include <memory>
#include <vector>

#include "energy/vertex_constraints.h"
#include "scene/scene.h"
#include "solve/metric.h"
#include "solve/sparse_factor.h"

namespace lamella::solve {

using film::Vec3;

// Where constraints leave a vertex only some directions, the three axes of the Laplacian (solve/laplacian.h)
// no longer part: with B the directions left to each vertex, the metric is B^T (L x 1) B, one matrix for all
// axes. Free vertices still meet each other axis by axis, so it costs about three scalar factorisations in
// one.
class VectorLaplacian : public Metric {
 public:
  // `constraints` must live on; its directions are read at each `factorise`.
  VectorLaplacian(const scene::Scene& scene, std::span<const double> weights,
                  const energy::VertexConstraints& constraints);

  bool factorise(std::span<const Vec3> x) override;
  void solve(std::span<Vec3> field) override;

 private:
  // The unknowns of a vertex and their directions.
  struct Freedoms {
    int first = 0;
    int count = 0;
    bool axes = false;  // the three axes themselves
    std::array<Vec3, 3> direction;
  };
  bool find_freedoms();
  void build_pattern();
  template <class Function>
  void for_each_entry(const Freedoms& a, const Freedoms& b, Function&& function) const;

  film::Film film_;
  std::vector<double> tension_;
  std::vector<double> weights_;
  const energy::VertexConstraints& constraints_;
  std::vector<Freedoms> freedoms_;
  int unknowns_ = 0;
  LowerMatrix matrix_;
  std::vector<int> edge_entry_;    // the first entry of each edge's block, in the order of for_each_entry
  std::vector<int> vertex_entry_;  // the same of each vertex's own block
  std::vector<int> places_;        // where those entries stand in the matrix
  std::unique_ptr<SparseFactor> factor_;
  std::vector<double> edge_weight_;
  std::vector<double> mass_;
  std::vector<double> right_;
};

}  // namespace lamella::solve
