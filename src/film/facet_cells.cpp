#include "film/facet_cells.h"

#include <algorithm>

namespace lamella::film {

namespace {

constexpr double cell_of_mean = 1.5;     // the width of a cell over the mean longest side of a facet
constexpr double most_cells_wide = 1.2;  // from its middle, of a facet that is not kept apart from the others

double longest_side(const std::array<Vec3, 3>& p) {
  return std::sqrt(
      std::max({squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])}));
}

}  // namespace

bool FacetCells::holds(const Film& film) const {
  const std::span<const Vec3> positions = film.positions();
  if (made_at_.size() != positions.size() || keys_.size() != film.triangle_rows()) return false;
  const double most = drift * drift * width_ * width_;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!(squared_length(positions[v] - made_at_[v]) < most)) return false;
  }
  return true;
}

void FacetCells::make(const Film& film, double margin) {
  const std::uint32_t count = film.triangle_rows();
  const std::span<const Vec3> positions = film.positions();
  made_at_.assign(positions.begin(), positions.end());
  keys_.resize(count);
  wide_.clear();
  reach_ = 0;
  const auto points = [&](std::uint32_t t) {
    const auto& c = film.corners(Triangle(t));
    return std::array<Vec3, 3>{positions[c[0].index], positions[c[1].index], positions[c[2].index]};
  };
  double sum = 0;
  for (std::uint32_t t = 0; t < count; ++t) sum += longest_side(points(t));
  width_ = sum > 0 ? cell_of_mean * sum / count : 1;
  std::size_t buckets = 64;
  while (buckets < count) buckets *= 2;
  first_.assign(buckets + 1, 0);
  constexpr std::uint64_t nowhere = ~std::uint64_t{0};
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::array<Vec3, 3> p = points(t);
    const Box box = box_of(p);
    const Vec3 middle = 0.5 / width_ * (box.low + box.high);
    const Vec3 half = 0.5 * (box.high - box.low);
    const double reach = std::max({half.x, half.y, half.z}) + margin * longest_side(p);
    const bool wide = reach > most_cells_wide * width_;
    if (!wide) reach_ = std::max(reach_, reach);
    keys_[t] = wide ? nowhere : key_of(cell(middle.x), cell(middle.y), cell(middle.z));
    if (wide)
      wide_.emplace_back(t);
    else
      ++first_[bucket_of(keys_[t]) + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) first_[b + 1] += first_[b];
  entries_.resize(first_[buckets]);
  // From the last on, so that each bucket's first entry is where it begins when all are placed.
  for (std::uint32_t t = count; t-- > 0;) {
    if (keys_[t] == nowhere) continue;
    const std::size_t bucket = bucket_of(keys_[t]);
    entries_[--first_[bucket + 1]] = {keys_[t], Triangle(t)};
  }
  for (std::size_t b = 0; b < buckets; ++b) first_[b] = first_[b + 1];
  first_[buckets] = static_cast<std::uint32_t>(entries_.size());
}

}  // namespace lamella::film
