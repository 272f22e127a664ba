#include "film/facet_cells.h"

#include <utility>

namespace lamella::film {

namespace {

constexpr double most_of_size = 1.25;  // the reach of facets in the first level
constexpr double cosine_of_20 = 0.94;

// Facets of one sheet have the same, and normals on the same side.
bool is_flipped(const RegionPair& regions) {
  return regions.behind < regions.front;
}

}  // namespace

void FacetCells::begin(std::size_t count, double size) {
  reach_ = size > 0 ? most_of_size * size : 1;
  std::size_t buckets = 2;
  for (hash_shift_ = 63; buckets < count; --hash_shift_) buckets *= 2;
  first_.assign(buckets, no_index);
  in_level_ = {};
  chunks_.clear();
  free_.clear();
  entries_.assign(count, {});
}

FacetCells::FacetBox FacetCells::box_at(const Entry& entry) const {
  FacetBox box;
  const Chunk& chunk = chunks_[entry.chunk];
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = chunk.low[k][entry.slot];
    box.high[k] = chunk.high[k][entry.slot];
  }
  return box;
}

void FacetCells::set_box(Chunk& chunk, std::uint32_t slot, const FacetBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    chunk.low[k][slot] = box.low[k];
    chunk.high[k][slot] = box.high[k];
  }
}

// The first normal is the axis. What was taken out counts until all are.
void FacetCells::add_normal(Chunk& chunk, const Entry& entry) {
  if (chunk.count == 1) {
    chunk.regions = entry.regions;
    chunk.axis = entry.normal;
    chunk.cosine = entry.regions.front == entry.regions.behind ? never : cosine_of_45;
    return;
  }
  const auto c = static_cast<double>(cosine(chunk.axis, entry.normal));
  if (!(chunk.regions == entry.regions) || !(c > static_cast<double>(cosine_of_45))) {
    chunk.cosine = never;
    return;
  }
  const double s = std::sqrt(std::max(0.0, 1 - c * c));
  chunk.cosine = std::max(chunk.cosine, static_cast<float>(std::sqrt(0.5) * (c + s)));
}

std::uint32_t FacetCells::chunk_with_room(std::uint64_t key) {
  std::uint32_t& first = first_[bucket_of(key)];
  for (std::uint32_t c = first; c != no_index; c = chunks_[c].next) {
    if (chunks_[c].key == key && chunks_[c].count < in_chunk) return c;
  }
  auto c = static_cast<std::uint32_t>(chunks_.size());
  if (free_.empty()) {
    chunks_.emplace_back();
  } else {
    c = free_.back();
    free_.pop_back();
  }
  chunks_[c].key = key;
  chunks_[c].next = std::exchange(first, c);
  return c;
}

void FacetCells::add(std::uint32_t row, std::uint64_t key, const FacetBox& box) {
  Entry& entry = entries_[row];
  entry.chunk = chunk_with_room(key);
  Chunk& chunk = chunks_[entry.chunk];
  entry.slot = chunk.count++;
  chunk.row[entry.slot] = row;
  set_box(chunk, entry.slot, box);
  add_normal(chunk, entry);
  ++in_level_[key % levels];
}

void FacetCells::take_out(std::uint32_t row) {
  Entry& entry = entries_[row];
  if (entry.chunk == no_index) return;
  Chunk& chunk = chunks_[entry.chunk];
  Entry& last = entries_[chunk.row[--chunk.count]];
  set_box(chunk, entry.slot, box_at(last));
  chunk.row[entry.slot] = chunk.row[chunk.count];
  last.slot = entry.slot;
  --in_level_[chunk.key % levels];
  const std::uint32_t c = std::exchange(entry.chunk, no_index);
  if (chunk.count > 0) return;
  std::uint32_t* link = &first_[bucket_of(chunk.key)];
  while (*link != c) link = &chunks_[*link].next;
  *link = chunk.next;
  free_.push_back(c);
}

void FacetCells::put(Triangle t, const std::array<Vec3, 3>& corners, double width,
                     const RegionPair& regions) {
  FacetBox box;
  double reach = 0;
  std::array<double, 3> middle;
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    box.low[k] = std::nextafter(static_cast<float>(low - width), -HUGE_VALF);
    box.high[k] = std::nextafter(static_cast<float>(high + width), HUGE_VALF);
    // As they are rounded: who looks for facets does so from these.
    middle[k] = 0.5 * (double{box.low[k]} + double{box.high[k]});
    reach = std::max(reach, 0.5 * (double{box.high[k]} - double{box.low[k]}));
  }
  std::uint32_t level = 0;
  double most = reach_;
  for (; level + 1 < levels && reach > most; ++level) most *= 2;
  const double wide = cell_of_reach * most;
  const bool flipped = is_flipped(regions);
  Vec3 normal = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
  if (flipped) normal = -normal;
  take_out(t.index);
  Entry& entry = entries_[t.index];
  entry.regions = flipped ? regions.flipped() : regions;
  entry.normal = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
  add(t.index, key_of(cell(middle[0] / wide), cell(middle[1] / wide), cell(middle[2] / wide), level), box);
}

void FacetCells::rename(std::span<const Triangle> rows, std::size_t count) {
  for (std::uint32_t n = 0; n < entries_.size(); ++n) {
    if (n >= rows.size() || !rows[n].valid()) take_out(n);
  }
  std::vector<Entry> entries(count);
  for (std::size_t n = 0; n < std::min(rows.size(), entries_.size()); ++n) {
    if (rows[n].valid()) entries[rows[n].index] = entries_[n];
  }
  entries_ = std::move(entries);
  for (Chunk& chunk : chunks_) {
    for (std::uint32_t slot = 0; slot < chunk.count; ++slot) chunk.row[slot] = rows[chunk.row[slot]].index;
  }
}

void FacetCells::order(std::span<Triangle> facets) const {
  std::sort(facets.begin(), facets.end(), [&](Triangle a, Triangle b) {
    const std::uint32_t i = entries_[a.index].chunk;
    const std::uint32_t k = entries_[b.index].chunk;
    return i != k ? i < k : a < b;
  });
}

bool FacetCells::is_relabelled(Triangle t, const RegionPair& regions) const {
  return !(entries_[t.index].regions == (is_flipped(regions) ? regions.flipped() : regions));
}

bool FacetCells::has_turned(Triangle t, const Vec3& normal, const RegionPair& regions) const {
  const bool flipped = is_flipped(regions);
  const Entry& entry = entries_[t.index];
  const Vec3 before{entry.normal[0], entry.normal[1], entry.normal[2]};
  const double cosine = flipped ? -dot(before, normal) : dot(before, normal);
  return !(cosine > 0 && cosine * cosine > cosine_of_20 * cosine_of_20 * squared_length(normal));
}

}  // namespace lamella::film
