#include "film/facet_cells.h"

#include <algorithm>

namespace lamella::film {

namespace {

constexpr double cell_of_mean = 1.5;  // the width of a cell over the mean longest side of a facet
constexpr double widest_cone = M_PI / 4;
constexpr double most_cells_wide = 1.2;  // from its middle, of a facet that is not kept apart from the others

double longest_side(const std::array<Vec3, 3>& p) {
  return std::sqrt(
      std::max({squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])}));
}

}  // namespace

FacetCells::NearBox FacetCells::rounded_outward(const Box& box, double margin) {
  NearBox result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    result.low[k] = std::nextafter(static_cast<float>(box.low[axis] - margin), -HUGE_VALF);
    result.high[k] = std::nextafter(static_cast<float>(box.high[axis] + margin), HUGE_VALF);
  }
  return result;
}

FacetCells::Sheet FacetCells::sheet_of(const RegionPair& regions) {
  const bool flipped = regions.behind < regions.front;
  return {flipped ? regions.flipped() : regions, flipped};
}

// The axis becomes the sum of normals.
void FacetCells::add_to(Cone& cone, Triangle t, bool first) const {
  if (first) cone.regions = regions_[t.index];
  if (!(cone.regions == regions_[t.index])) cone.regions = {};
  cone.axis += normals_[t.index];
}

// Whether any normal of the one is within 45 degrees of any of the other.
bool FacetCells::are_one_sheet(const Cone& a, const Cone& b) {
  if (a.regions.front == a.regions.behind || !(a.regions == b.regions)) return false;
  const double between = widest_cone - a.angle - b.angle;
  return between > 0 && angle_of(dot(a.axis, b.axis)) < between;
}

void FacetCells::make(std::span<const std::array<Vec3, 3>> facets, std::span<const double> widths,
                      std::span<const RegionPair> regions) {
  const auto count = static_cast<std::uint32_t>(facets.size());
  regions_.resize(count);
  normals_.resize(count);
  keys_.resize(count);
  near_boxes_.resize(count);
  wide_.clear();
  reach_ = 0;
  double sum = 0;
  for (std::uint32_t t = 0; t < count; ++t) sum += longest_side(facets[t]);
  width_ = sum > 0 ? cell_of_mean * sum / count : 1;
  std::size_t buckets = 64;
  while (buckets < count) buckets *= 2;
  first_.assign(buckets + 1, 0);
  constexpr std::uint64_t nowhere = ~std::uint64_t{0};
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::array<Vec3, 3>& p = facets[t];
    const Box box = box_of(p);
    const Sheet sheet = sheet_of(regions[t]);
    const Vec3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
    regions_[t] = sheet.regions;
    normals_[t] = sheet.flipped ? -normal : normal;
    const Vec3 middle = 0.5 / width_ * (box.low + box.high);
    const Vec3 half = 0.5 * (box.high - box.low);
    const double reach = std::max({half.x, half.y, half.z}) + widths[t];
    near_boxes_[t] = rounded_outward(box, widths[t]);
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
  cones_.assign(buckets, {});
  for (std::size_t b = 0; b < buckets; ++b) {
    Cone& cone = cones_[b];
    for (std::uint32_t n = first_[b]; n < first_[b + 1]; ++n) add_to(cone, entries_[n].facet, n == first_[b]);
    cone.axis = unit(cone.axis);
    for (std::uint32_t n = first_[b]; n < first_[b + 1]; ++n) widen(cone, entries_[n].facet);
    cone.angle = angle_of(cone.cosine);
  }
}

void FacetCells::sort_by_tower(std::span<const Box> boxes) {
  asked_.resize(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const Vec3 middle = 0.5 / width_ * (boxes[i].low + boxes[i].high);
    asked_[i] = {key_of(cell(middle.x), cell(middle.y), cell(middle.z)), i};
  }
  std::sort(asked_.begin(), asked_.end(),
            [](const Asked& a, const Asked& b) { return a.key != b.key ? a.key < b.key : a.row < b.row; });
}

void FacetCells::add_candidate(Triangle t) {
  const NearBox& box = near_boxes_[t.index];
  candidates_.facet.push_back(t);
  for (std::size_t k = 0; k < 3; ++k) {
    candidates_.low[k].push_back(box.low[k]);
    candidates_.high[k].push_back(box.high[k]);
  }
}

void FacetCells::gather(const Box& box, const Cone& cone) {
  candidates_.facet.clear();
  for (std::size_t k = 0; k < 3; ++k) {
    candidates_.low[k].clear();
    candidates_.high[k].clear();
  }
  for (const Triangle t : wide_) add_candidate(t);
  const double reach = reach_;
  const Vec3 low = (1 / width_) * (box.low - Vec3{reach, reach, reach});
  const Vec3 high = (1 / width_) * (box.high + Vec3{reach, reach, reach});
  const double cells = (high.x - low.x + 1) * (high.y - low.y + 1) * (high.z - low.z + 1);
  if (!(cells < most_cells)) {
    for (const Entry& entry : entries_) add_candidate(entry.facet);
    return;
  }
  const std::int64_t top = cell(high.z);
  for (std::int64_t i = cell(low.x); i <= cell(high.x); ++i) {
    for (std::int64_t j = cell(low.y); j <= cell(high.y); ++j) {
      for (std::int64_t k = cell(low.z); k <= top; k = (k / tower + 1) * tower) {
        const std::uint64_t lowest = key_of(i, j, k);
        const std::uint64_t span = key_of(i, j, std::min(top, (k / tower + 1) * tower - 1)) - lowest;
        const std::size_t bucket = bucket_of(lowest);
        if (first_[bucket] == first_[bucket + 1] || are_one_sheet(cone, cones_[bucket])) continue;
        for (std::uint32_t n = first_[bucket]; n < first_[bucket + 1]; ++n) {
          if (entries_[n].key - lowest <= span) add_candidate(entries_[n].facet);
        }
      }
    }
  }
}

std::size_t FacetCells::pick(const NearBox& box) {
  const std::size_t count = candidates_.facet.size();
  met_.resize(count);
  picked_.resize(count + 1);
  const float* const low[3] = {candidates_.low[0].data(), candidates_.low[1].data(),
                               candidates_.low[2].data()};
  const float* const high[3] = {candidates_.high[0].data(), candidates_.high[1].data(),
                                candidates_.high[2].data()};
  std::int32_t* const met = met_.data();
  for (std::size_t n = 0; n < count; ++n) {
    met[n] = static_cast<std::int32_t>(low[0][n] <= box.high[0]) &
             static_cast<std::int32_t>(high[0][n] >= box.low[0]) &
             static_cast<std::int32_t>(low[1][n] <= box.high[1]) &
             static_cast<std::int32_t>(high[1][n] >= box.low[1]) &
             static_cast<std::int32_t>(low[2][n] <= box.high[2]) &
             static_cast<std::int32_t>(high[2][n] >= box.low[2]);
  }
  std::size_t picked = 0;
  for (std::size_t n = 0; n < count; ++n) {
    picked_[picked] = static_cast<std::uint32_t>(n);
    picked += static_cast<std::size_t>(met[n]);
  }
  return picked;
}

}  // namespace lamella::film
