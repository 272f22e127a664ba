#include "solve/laplacian.h"

#include <algorithm>
#include <cmath>

#include "solve/cotangent.h"

namespace lamella::solve {

namespace {

// Parts of the mass matrix added to L, per unit of (tension / film area): enough to make L definite where the
// film floats freely, next to nothing where wires hold it.
constexpr double free_shift = 1e-2;
constexpr double held_shift = 1e-8;

}  // namespace

Laplacian::Laplacian(const scene::Scene& scene, std::span<const double> weights) : film_(scene.film) {
  film_.edit_position_rows() = {};
  const auto tension = film_.columns(film::ElementKind::facet).reals("tension");
  tension_.assign(tension.begin(), tension.end());
  row_of_vertex_.assign(weights.size(), -1);
  for (std::uint32_t v = 0; v < weights.size(); ++v) {
    if (weights[v] == 0 || !film_.first_end(film::Vertex(v)).valid()) continue;
    row_of_vertex_[v] = static_cast<int>(vertex_of_row_.size());
    vertex_of_row_.push_back(v);
  }
  const std::size_t rows = vertex_of_row_.size();
  shift_ = rows == weights.size() ? free_shift : held_shift;

  // Columns: the diagonal first, then the edges to higher rows.
  const std::uint32_t edges = film_.edge_rows();
  const auto rows_of = [&](std::uint32_t e) {
    const auto& ends = film_.ends(film::Edge(e));
    return std::minmax(row_of_vertex_[ends[0].index], row_of_vertex_[ends[1].index]);
  };
  matrix_.column_start.assign(rows + 1, 0);
  for (std::size_t i = 0; i < rows; ++i) matrix_.column_start[i + 1] = 1;
  for (std::uint32_t e = 0; e < edges; ++e) {
    const auto [low, high] = rows_of(e);
    if (low >= 0 && low != high) ++matrix_.column_start[static_cast<std::size_t>(low) + 1];
  }
  for (std::size_t i = 0; i < rows; ++i) matrix_.column_start[i + 1] += matrix_.column_start[i];
  const auto entries = static_cast<std::size_t>(matrix_.column_start[rows]);
  matrix_.row.resize(entries);
  matrix_.value.resize(entries);
  std::vector<int> next(matrix_.column_start.begin(), matrix_.column_start.end() - 1);
  for (std::size_t i = 0; i < rows; ++i)
    matrix_.row[static_cast<std::size_t>(next[i]++)] = static_cast<int>(i);
  entry_of_edge_.assign(edges, -1);
  for (std::uint32_t e = 0; e < edges; ++e) {
    const auto [low, high] = rows_of(e);
    if (low < 0 || low == high) continue;
    entry_of_edge_[e] = next[static_cast<std::size_t>(low)]++;
    matrix_.row[static_cast<std::size_t>(entry_of_edge_[e])] = high;
  }
  std::vector<Vec3> places;
  for (const std::uint32_t v : vertex_of_row_) places.push_back(scene.film.position(film::Vertex(v)));
  factor_ = std::make_unique<SparseFactor>(matrix_, places);
  edge_weight_.resize(edges);
  mass_.resize(weights.size());
  right_.resize(3 * rows);
}

bool Laplacian::factorise(std::span<const Vec3> x) {
  if (vertex_of_row_.empty()) return true;
  const double total_area = cotangent_weights(film_, tension_, x, edge_weight_, mass_);
  if (!std::isfinite(total_area)) return false;

  const double shift = total_area > 0 ? shift_ / total_area * 4 * M_PI : 0;
  for (std::size_t i = 0; i < vertex_of_row_.size(); ++i) {
    const double mass = mass_[vertex_of_row_[i]];
    matrix_.value[static_cast<std::size_t>(matrix_.column_start[i])] = shift * mass + (mass > 0 ? 0 : 1);
  }
  for (std::uint32_t e = 0; e < edge_weight_.size(); ++e) {
    const double weight = std::max(edge_weight_[e], least_cotangent_weight);
    const int entry = entry_of_edge_[e];
    if (entry >= 0) matrix_.value[static_cast<std::size_t>(entry)] = -weight;
    for (const film::Vertex v : film_.ends(film::Edge(e))) {
      const int row = row_of_vertex_[v.index];
      if (row >= 0)
        matrix_.value[static_cast<std::size_t>(matrix_.column_start[static_cast<std::size_t>(row)])] +=
            weight;
    }
  }
  return factor_->factorise(matrix_);
}

void Laplacian::solve(std::span<Vec3> field) {
  const std::size_t rows = vertex_of_row_.size();
  for (std::size_t i = 0; i < rows; ++i) {
    const Vec3& f = field[vertex_of_row_[i]];
    right_[i] = f.x;
    right_[rows + i] = f.y;
    right_[2 * rows + i] = f.z;
  }
  factor_->solve(right_, 3);
  std::fill(field.begin(), field.end(), Vec3{});
  for (std::size_t i = 0; i < rows; ++i)
    field[vertex_of_row_[i]] = {right_[i], right_[rows + i], right_[2 * rows + i]};
}

}  // namespace lamella::solve
