#include "solve/film_metric.h"

#include "solve/laplacian.h"
#include "solve/vector_laplacian.h"

namespace lamella::solve {

std::unique_ptr<Metric> film_metric(const scene::Scene& scene, Problem& problem) {
  if (problem.energy().constraints().empty()) return std::make_unique<Laplacian>(scene, problem.weights());
  return std::make_unique<VectorLaplacian>(scene, problem.weights(), problem.energy().constraints());
}

}  // namespace lamella::solve
