#include "solve/dissection.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <omp.h>

#include "solve/sparse_factor.h"

namespace lamella::solve {
namespace {

// A square grid, each point tied to its four neighbours, and multipliers tied to chosen columns of points.
struct Grid {
  LowerMatrix matrix;
  std::vector<film::Vec3> places;
};

Grid grid(int n, const std::vector<std::pair<int, int>>& multipliers = {}) {
  Grid result;
  const int rows = n * n;
  result.matrix.column_start.push_back(0);
  for (int i = 0; i < rows; ++i) {
    const int x = i % n;
    const int y = i / n;
    result.places.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    std::vector<int>& row = result.matrix.row;
    row.push_back(i);
    if (x + 1 < n) row.push_back(i + 1);
    if (y + 1 < n) row.push_back(i + n);
    for (std::size_t m = 0; m < multipliers.size(); ++m) {
      if (x >= multipliers[m].first && x < multipliers[m].second) row.push_back(rows + static_cast<int>(m));
    }
    result.matrix.column_start.push_back(static_cast<int>(row.size()));
  }
  for (std::size_t m = 0; m < multipliers.size(); ++m) {
    result.matrix.row.push_back(rows + static_cast<int>(m));
    result.matrix.column_start.push_back(static_cast<int>(result.matrix.row.size()));
  }
  result.matrix.value.assign(result.matrix.row.size(), 1.0);
  return result;
}

// Places that only rounding tells apart are parted all the same, or not at all: the search ends.
TEST(Dissection, EndsWherePlacesAreAllButTheSame) {
  Grid g = grid(60);
  for (film::Vec3& place : g.places)
    place = {place.x < 30 ? 0.5 : 0.5 + 1.2e-16, place.y < 20 ? 0.0 : 1e-310, 0};
  const Dissection found = dissection(g.matrix, g.places, 200);
  EXPECT_EQ(found.piece.size(), g.places.size());
}

// The tree is told by the numbers alone: rows of two pieces that are tied must be one above the other, so
// removing the last piece must leave parts without ties.
TEST(Dissection, TheLastSeamPartsTheRest) {
  const Grid g = grid(60);
  const std::vector<int> piece = dissection(g.matrix, g.places, 200).piece;
  ASSERT_EQ(piece.size(), g.places.size());
  const int last = *std::max_element(piece.begin(), piece.end());
  const auto seam = std::count(piece.begin(), piece.end(), last);
  EXPECT_LE(seam, 62);  // a straight line
  // Flood one side.
  std::vector<int> reached(piece.size(), 0);
  std::vector<int> open;
  for (std::size_t i = 0; open.empty(); ++i) {
    if (piece[i] != last) open.push_back(static_cast<int>(i));
  }
  std::size_t count = 0;
  while (!open.empty()) {
    const auto i = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (piece[i] == last || reached[i] != 0) continue;
    reached[i] = 1;
    ++count;
    const int x = static_cast<int>(i) % 60;
    if (x > 0) open.push_back(static_cast<int>(i) - 1);
    if (x < 59) open.push_back(static_cast<int>(i) + 1);
    if (i >= 60) open.push_back(static_cast<int>(i) - 60);
    if (i + 60 < piece.size()) open.push_back(static_cast<int>(i) + 60);
  }
  EXPECT_GT(count, 600U);
  EXPECT_LT(count, 3000U);
}

TEST(Dissection, MultipliersFollowAllTheyAreTiedTo) {
  const Grid g = grid(60, {{0, 60}, {0, 5}, {20, 40}});
  const std::vector<int> piece = dissection(g.matrix, g.places, 200).piece;
  for (std::size_t j = 0; j < g.places.size(); ++j) {
    for (int at = g.matrix.column_start[j]; at < g.matrix.column_start[j + 1]; ++at) {
      const auto row = static_cast<std::size_t>(g.matrix.row[static_cast<std::size_t>(at)]);
      if (row >= g.places.size()) {
        EXPECT_GT(piece[row], piece[j]);
      }
    }
  }
}

TEST(Dissection, RowsAtOnePlaceAndNoRowsAtAll) {
  Grid g = grid(20);
  std::fill(g.places.begin(), g.places.end(), film::Vec3{1, 1, 1});
  for (const int piece : dissection(g.matrix, g.places, 200).piece) EXPECT_EQ(piece, 0);
  const LowerMatrix one{{0, 1}, {0}, {1.0}};
  EXPECT_EQ(dissection(one, {}, 200).piece.size(), 1U);
}

// Definite, as a film's Laplacian.
Grid definite_grid(int n) {
  Grid g = grid(n);
  for (std::size_t j = 0; j < g.places.size(); ++j) {
    const auto first = static_cast<std::size_t>(g.matrix.column_start[j]);
    const auto last = static_cast<std::size_t>(g.matrix.column_start[j + 1]);
    g.matrix.value[first] = 4.5;
    for (std::size_t at = first + 1; at < last; ++at) g.matrix.value[at] = -1;
  }
  return g;
}

// The order must not matter for what is solved.
TEST(Dissection, FactorisesTheSameMatrix) {
  const Grid g = definite_grid(70);
  SparseFactor ordered(g.matrix, g.places);
  SparseFactor plain(g.matrix);
  ASSERT_TRUE(ordered.factorise(g.matrix));
  ASSERT_TRUE(plain.factorise(g.matrix));
  std::vector<double> a(g.places.size());
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<double>(i * 7919 % 101);
  std::vector<double> b = a;
  ordered.solve(a, 1);
  plain.solve(b, 1);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-10);
  EXPECT_EQ(ordered.negative_pivots(), plain.negative_pivots());
}

// To the bit.
TEST(Dissection, ThreadsChangeNothing) {
  const Grid g = definite_grid(230);
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    SparseFactor factor(g.matrix, g.places);
    ASSERT_TRUE(factor.factorise(g.matrix));
    solutions.emplace_back(g.places.size());
    for (std::size_t i = 0; i < g.places.size(); ++i)
      solutions.back()[i] = static_cast<double>(i * 7919 % 101);
    factor.solve(solutions.back(), 1);
  }
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}

}  // namespace
}  // namespace lamella::solve
