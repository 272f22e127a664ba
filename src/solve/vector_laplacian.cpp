#include "solve/vector_laplacian.h"

#include <algorithm>
#include <cmath>

#include "solve/cotangent.h"

namespace lamella::solve {

namespace {

// As in the scalar Laplacian: a little mass keeps a film definite that nothing holds in some direction.
constexpr double shift_per_mass = 1e-2;

}  // namespace

VectorLaplacian::VectorLaplacian(const scene::Scene& scene, std::span<const double> weights,
                                 const energy::VertexConstraints& constraints)
    : film_(scene.film),
      weights_(weights.begin(), weights.end()),
      constraints_(constraints),
      freedoms_(weights.size()),
      edge_weight_(scene.film.edge_rows()),
      mass_(weights.size()) {
  film_.edit_position_rows() = {};
  const auto tension = film_.columns(film::ElementKind::facet).reals("tension");
  tension_.assign(tension.begin(), tension.end());
}

// True if the numbers of freedoms are what they were, so that the pattern stands.
bool VectorLaplacian::find_freedoms() {
  bool same = factor_ != nullptr;
  int next = 0;
  for (std::uint32_t v = 0; v < freedoms_.size(); ++v) {
    Freedoms f;
    f.first = next;
    if (weights_[v] != 0 && film_.first_end(film::Vertex(v)).valid()) {
      f.axes = !constraints_.holds(v);
      f.direction = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
      f.count = f.axes ? 3 : constraints_.allowed(v, f.direction);
    }
    same = same && f.count == freedoms_[v].count && f.axes == freedoms_[v].axes;
    next += f.count;
    freedoms_[v] = f;
  }
  unknowns_ = next;
  return same;
}

// Calls function(unknown of a, unknown of b, product of their directions), skipping what is zero by nature.
template <class Function>
void VectorLaplacian::for_each_entry(const Freedoms& a, const Freedoms& b, Function&& function) const {
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      if (a.axes && b.axes && i != j) continue;
      const double product =
          dot(a.direction[static_cast<std::size_t>(i)], b.direction[static_cast<std::size_t>(j)]);
      function(a.first + i, b.first + j, product);
    }
  }
}

void VectorLaplacian::build_pattern() {
  struct Entry {
    int column = 0;
    int row = 0;
    int order = 0;
  };
  std::vector<Entry> entries;
  const auto add_block = [&](const Freedoms& a, const Freedoms& b, bool own) {
    const int first = static_cast<int>(entries.size());
    for_each_entry(a, b, [&](int row, int column, double) {
      if (own && column > row) return;
      entries.push_back({std::min(row, column), std::max(row, column), static_cast<int>(entries.size())});
    });
    return first;
  };
  vertex_entry_.clear();
  edge_entry_.clear();
  for (const Freedoms& f : freedoms_) vertex_entry_.push_back(add_block(f, f, true));
  for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
    const auto& ends = film_.ends(film::Edge(e));
    edge_entry_.push_back(add_block(freedoms_[ends[0].index], freedoms_[ends[1].index], false));
  }
  std::vector<Entry> sorted = entries;
  std::sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.column, a.row) < std::pair(b.column, b.row);
  });
  matrix_.column_start.assign(static_cast<std::size_t>(unknowns_) + 1, 0);
  matrix_.row.clear();
  places_.resize(entries.size());
  const Entry* last = nullptr;
  for (const Entry& entry : sorted) {
    const bool repeated = last != nullptr && last->column == entry.column && last->row == entry.row;
    if (!repeated) {
      matrix_.row.push_back(entry.row);
      ++matrix_.column_start[static_cast<std::size_t>(entry.column) + 1];
    }
    places_[static_cast<std::size_t>(entry.order)] = static_cast<int>(matrix_.row.size()) - 1;
    last = &entry;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns_); ++i)
    matrix_.column_start[i + 1] += matrix_.column_start[i];
  matrix_.value.assign(matrix_.row.size(), 0.0);
  right_.resize(static_cast<std::size_t>(unknowns_));
  factor_ = std::make_unique<SparseFactor>(matrix_);
}

bool VectorLaplacian::factorise(std::span<const Vec3> x) {
  if (!find_freedoms()) build_pattern();
  if (unknowns_ == 0) return true;
  const double area = cotangent_weights(film_, tension_, x, edge_weight_, mass_);
  if (!std::isfinite(area)) return false;
  const double shift = area > 0 ? shift_per_mass / area * 4 * M_PI : 0;
  std::fill(matrix_.value.begin(), matrix_.value.end(), 0.0);
  const auto at = [&](int entry) -> double& {
    return matrix_.value[static_cast<std::size_t>(places_[static_cast<std::size_t>(entry)])];
  };
  const auto add_own = [&](std::uint32_t v, double weight) {
    int entry = vertex_entry_[v];
    for_each_entry(freedoms_[v], freedoms_[v], [&](int row, int column, double product) {
      if (column <= row) at(entry++) += weight * product;
    });
  };
  for (std::uint32_t v = 0; v < freedoms_.size(); ++v) add_own(v, shift * mass_[v] + (mass_[v] > 0 ? 0 : 1));
  for (std::uint32_t e = 0; e < edge_weight_.size(); ++e) {
    const double weight = std::max(edge_weight_[e], least_cotangent_weight);
    const auto& ends = film_.ends(film::Edge(e));
    add_own(ends[0].index, weight);
    add_own(ends[1].index, weight);
    int entry = edge_entry_[e];
    for_each_entry(freedoms_[ends[0].index], freedoms_[ends[1].index],
                   [&](int, int, double product) { at(entry++) -= weight * product; });
  }
  return factor_->factorise(matrix_);
}

void VectorLaplacian::solve(std::span<Vec3> field) {
  for (std::size_t v = 0; v < freedoms_.size(); ++v) {
    const Freedoms& f = freedoms_[v];
    for (int i = 0; i < f.count; ++i) {
      right_[static_cast<std::size_t>(f.first + i)] = dot(field[v], f.direction[static_cast<std::size_t>(i)]);
    }
  }
  if (unknowns_ > 0) factor_->solve(right_, 1);
  for (std::size_t v = 0; v < freedoms_.size(); ++v) {
    const Freedoms& f = freedoms_[v];
    field[v] = {};
    for (int i = 0; i < f.count; ++i) {
      field[v] += right_[static_cast<std::size_t>(f.first + i)] * f.direction[static_cast<std::size_t>(i)];
    }
  }
}

}  // namespace lamella::solve
