// Cotangent weights of a film's edges.
#pragma once

#include <span>

#include "film/film.h"

namespace lamella::solve {

// For each edge the sum of (tension/2) cot(opposite angle) over its triangles; for each vertex a third of
// tension * area around. Both are overwritten. Returns the total area.
double cotangent_weights(const film::Film& film, std::span<const double> tension,
                         std::span<const film::Vec3> x, std::span<double> edge_weight,
                         std::span<double> vertex_mass);

// The smallest weight an edge gets in a metric: obtuse triangles would make it indefinite.
inline constexpr double least_cotangent_weight = 1e-3;

}  // namespace lamella::solve
