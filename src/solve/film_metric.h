// The metric that suits a film: the scalar Laplacian, or where constraints couple the axes the vector one.
#pragma once

#include <memory>

#include "scene/scene.h"
#include "solve/metric.h"
#include "solve/problem.h"

namespace lamella::solve {

// Refers to the problem, which must outlive it.
std::unique_ptr<Metric> film_metric(const scene::Scene& scene, Problem& problem);

}  // namespace lamella::solve
