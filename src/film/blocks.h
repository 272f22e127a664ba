// Work on rows shared out over threads, with the same result to the bit for any number of them.
#pragma once

#include <array>
#include <cstddef>

namespace lamella::film {

// From so many rows on it pays to wake other threads; then rows are cut into so many blocks, and what blocks
// sum is added in their order.
inline constexpr std::size_t rows_worth_threads = 24576;
inline constexpr std::size_t block_count = 32;

// Calls function(block, first, last) for blocks that together are the rows from 0 to `count`, side by side:
// one block where there are few rows, else `block_count`.
template <class Function>
void for_each_numbered_block(std::size_t count, Function&& function) {
  if (count < rows_worth_threads) {
    function(std::size_t{0}, std::size_t{0}, count);
    return;
  }
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < block_count; ++b)
    function(b, b * count / block_count, (b + 1) * count / block_count);
}

// Calls function(first, last) for blocks that together are the rows from 0 to `count`, side by side. The
// function must not throw, and no block may read what another one writes.
template <class Function>
void for_each_block(std::size_t count, Function&& function) {
  for_each_numbered_block(count,
                          [&](std::size_t, std::size_t first, std::size_t last) { function(first, last); });
}

// The sum of what function(first, last) returns: a number, or whatever has a 0 and can be added up.
template <class Function>
auto sum_of_blocks(std::size_t count, Function&& function) {
  using Sum = decltype(function(count, count));
  if (count < rows_worth_threads) return function(std::size_t{0}, count);
  std::array<Sum, block_count> parts;
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < block_count; ++b)
    parts[b] = function(b * count / block_count, (b + 1) * count / block_count);
  Sum sum{};
  for (const Sum& part : parts) sum += part;
  return sum;
}

}  // namespace lamella::film
