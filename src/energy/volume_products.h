// The products of volume gradients with fields, shared out over threads. For files that are compiled with
// them.
#pragma once

#include "energy/volume_gradient.h"
#include "film/blocks.h"

namespace lamella::energy {

// The products of all vertices' gradients.
template <class Function>
void multiply_all(const VolumeGradient& gradient, std::span<const double> weights, const Function& fields,
                  VolumeGradient::Products& products) {
  products.parts.resize(weights.size() < film::rows_worth_threads ? 1 : film::block_count);
  film::for_each_numbered_block(weights.size(), [&](std::size_t block, std::size_t first, std::size_t last) {
    products.parts[block].clear();
    gradient.add_rows(first, last, weights, fields, products.parts[block]);
  });
  gradient.collect(weights, fields, products);
}

}  // namespace lamella::energy
