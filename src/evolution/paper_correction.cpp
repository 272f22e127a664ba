#include "evolution/paper_correction.h"

#include <Eigen/Dense>
#include <algorithm>

namespace lamella::evolution {

namespace {

using energy::GramEntry;
using film::Vec3;

// Directions with less than this part of the largest eigenvalue are those along a film or a border.
constexpr double unseen = 0.1;

std::vector<GramEntry> pattern_of(const film::Film& film, const std::vector<int>& row_of_region, int rows) {
  std::vector<GramEntry> pattern;
  for (int i = 0; i < rows; ++i) pattern.push_back({i, i});
  for (const film::RegionPair& pair : film.connectivity().triangle_regions) {
    const int a = row_of_region[pair.behind.index];
    const int b = row_of_region[pair.front.index];
    if (a >= 0 && b >= 0 && a != b) pattern.push_back({std::max(a, b), std::min(a, b)});
  }
  std::sort(pattern.begin(), pattern.end());
  pattern.erase(std::unique(pattern.begin(), pattern.end()), pattern.end());
  return pattern;
}

// The shortest w with N w = b in the directions that N sees.
Vec3 best(const std::array<double, 9>& s) {
  Eigen::Matrix3d n;
  n << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  const Eigen::Vector3d b(s[6], s[7], s[8]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(n);
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double value = eigen.eigenvalues()[k];
    if (value > unseen * eigen.eigenvalues()[2]) {
      const Eigen::Vector3d direction = eigen.eigenvectors().col(k);
      w += direction.dot(b) / value * direction;
    }
  }
  return {w[0], w[1], w[2]};
}

}  // namespace

PaperCorrection::PaperCorrection(const film::Film& film, std::vector<int> row_of_region, int rows)
    : pattern_(pattern_of(film, row_of_region, rows)),
      values_(pattern_.size()),
      sums_(film.vertex_rows()),
      solver_(rows, pattern_) {
  const auto entry = [&](int a, int b) {
    const GramEntry wanted{std::max(a, b), std::min(a, b)};
    return static_cast<int>(std::lower_bound(pattern_.begin(), pattern_.end(), wanted) - pattern_.begin());
  };
  const film::Connectivity& complex = film.connectivity();
  for (std::size_t t = 0; t < complex.triangle_vertices.size(); ++t) {
    const film::RegionPair pair = complex.triangle_regions[t];
    Triangle triangle{complex.triangle_vertices[t], row_of_region[pair.behind.index],
                      row_of_region[pair.front.index]};
    if (pair.behind == pair.front || (triangle.behind < 0 && triangle.front < 0)) continue;
    if (triangle.behind >= 0) triangle.entry_behind = entry(triangle.behind, triangle.behind);
    if (triangle.front >= 0) triangle.entry_front = entry(triangle.front, triangle.front);
    if (triangle.behind >= 0 && triangle.front >= 0)
      triangle.entry_mixed = entry(triangle.behind, triangle.front);
    triangles_.push_back(triangle);
  }
}

bool PaperCorrection::displacements(std::span<const Vec3> x, std::span<const double> errors,
                                    std::span<double> levels, std::span<Vec3> result) {
  const auto vector_area = [&](const Triangle& t) {
    const Vec3& a = x[t.corners[0].index];
    return 0.5 * cross(x[t.corners[1].index] - a, x[t.corners[2].index] - a);
  };
  std::fill(values_.begin(), values_.end(), 0.0);
  for (const Triangle& t : triangles_) {
    const double area = length(vector_area(t));
    if (t.entry_behind >= 0) values_[static_cast<std::size_t>(t.entry_behind)] += area;
    if (t.entry_front >= 0) values_[static_cast<std::size_t>(t.entry_front)] += area;
    if (t.entry_mixed >= 0) values_[static_cast<std::size_t>(t.entry_mixed)] -= area;
  }
  if (!solver_.factorise(values_)) return false;
  solver_.solve(errors, levels);
  const auto level = [&](int row) { return row < 0 ? 0.0 : levels[static_cast<std::size_t>(row)]; };
  std::fill(sums_.begin(), sums_.end(), std::array<double, 9>{});
  for (const Triangle& t : triangles_) {
    const Vec3 along = vector_area(t);
    const double area = length(along);
    if (!(area > 0)) continue;
    const Vec3 n = along / area;
    const double d = level(t.behind) - level(t.front);
    const std::array<double, 9> share{n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z,
                                      n.z * n.z, d * n.x,   d * n.y,   d * n.z};
    for (const film::Vertex v : t.corners) {
      for (std::size_t k = 0; k < 9; ++k) sums_[v.index][k] += area * share[k];
    }
  }
  for (std::size_t v = 0; v < sums_.size(); ++v)
    result[v] = sums_[v][0] + sums_[v][3] + sums_[v][5] > 0 ? best(sums_[v]) : Vec3{};
  return true;
}

}  // namespace lamella::evolution
