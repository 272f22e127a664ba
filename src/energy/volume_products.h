// The products of volume gradients with fields, shared out over threads. For files that are compiled with
// them.
#pragma once

#include "energy/volume_gradient.h"
#include "film/blocks.h"

namespace lamella::energy {

// VolumeGradient::multiply of all vertices.
template <class Function>
void multiply_all(const VolumeGradient& gradient, std::span<const double> weights, const Function& fields,
                  VolumeGradient::Products& products) {
  const std::size_t sums = gradient.pattern().size() + 2 * static_cast<std::size_t>(gradient.rows());
  if (weights.size() < film::rows_worth_threads || sums * film::block_count > weights.size()) {
    gradient.multiply(0, weights.size(), weights, fields, products);
    return;
  }
  products = film::sum_of_blocks(weights.size(), [&](std::size_t begin, std::size_t end) {
    VolumeGradient::Products part;
    gradient.multiply(begin, end, weights, fields, part);
    return part;
  });
}

}  // namespace lamella::energy
