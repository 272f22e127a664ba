#include "energy/volume_gradient.h"

#include <algorithm>
#include <map>

#include "energy/triangle.h"

namespace lamella::energy {

namespace {

struct RegionPairOrder {
  bool operator()(const film::RegionPair& a, const film::RegionPair& b) const {
    return a.front < b.front || (a.front == b.front && a.behind < b.behind);
  }
};

film::RegionPair sorted(film::RegionPair pair) {
  return pair.behind < pair.front ? pair.flipped() : pair;
}

constexpr std::ptrdiff_t most_recent = 32;
constexpr film::RegionPair mixed{film::Region{1}, film::Region{0}};  // never sorted, so never a film's pair

}  // namespace

VolumeGradient::VolumeGradient(const film::Film& film, std::span<const int> row_of_region, int rows,
                               std::span<const FieldEdge> contents, int order,
                               std::span<const FixedRow> fixed)
    : rows_(rows), order_(order) {
  if (rows == 0) return;
  find_borders(film, row_of_region, contents, fixed);
  slots_.resize(slot_rows_.size());
  next_slots_.resize(slot_rows_.size());
  build_pattern();
}

// A vertex all of whose labelled triangles part the same two regions lies inside a film; others are borders.
void VolumeGradient::find_borders(const film::Film& film, std::span<const int> row_of_region,
                                  std::span<const FieldEdge> contents, std::span<const FixedRow> fixed) {
  const film::View view = film.view();
  const std::size_t vertices = view.positions.size();
  std::vector<film::RegionPair> pair_at(vertices);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const film::RegionPair pair = sorted(view.regions[t]);
    if (pair.front == pair.behind) continue;
    for (const film::Vertex v : view.triangles[t]) {
      film::RegionPair& at = pair_at[v.index];
      if (at == film::RegionPair{}) {
        at = pair;
      } else if (!(at == pair)) {
        at = mixed;
      }
    }
  }
  const std::vector<RimEdge> rims = open_rims(film);
  for (const RimEdge& rim : rims) pair_at[rim.from.index] = pair_at[rim.to.index] = mixed;
  for (const FieldEdge& content : contents) pair_at[content.from.index] = pair_at[content.to.index] = mixed;
  for (const FixedRow& row : fixed) {
    for (const std::uint32_t v : row.vertices) pair_at[v] = mixed;
  }

  std::map<film::RegionPair, std::uint32_t, RegionPairOrder> known;
  place_of_vertex_.assign(vertices, none);
  std::vector<std::uint32_t> border_of_vertex(vertices, none);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (pair_at[v] == mixed) {
      border_of_vertex[v] = static_cast<std::uint32_t>(borders_.size());
      borders_.push_back({v});
    } else if (!(pair_at[v] == film::RegionPair{})) {
      const Pair pair{row_of_region[pair_at[v].behind.index], row_of_region[pair_at[v].front.index]};
      if (pair.high < 0 && pair.low < 0) continue;
      const auto [at, added] = known.try_emplace(pair_at[v], static_cast<std::uint32_t>(pairs_.size()));
      if (added) pairs_.push_back(pair);
      place_of_vertex_[v] = at->second;
    }
  }

  for (std::size_t b = 0; b < borders_.size(); ++b) {
    place_of_vertex_[borders_[b].vertex] = static_cast<std::uint32_t>(pairs_.size() + b);
  }

  // The rows at each border vertex, then a slot for each.
  std::vector<std::vector<int>> rows_at(borders_.size());
  const auto touch_row = [&](std::uint32_t b, int row) {
    if (b == none || row < 0) return;
    if (std::find(rows_at[b].begin(), rows_at[b].end(), row) == rows_at[b].end()) rows_at[b].push_back(row);
  };
  const auto touch = [&](film::Vertex v, film::Region region) {
    touch_row(border_of_vertex[v.index], row_of_region[region.index]);
  };
  std::vector<std::uint32_t> near;  // triangles at borders: few
  for (std::uint32_t t = 0; t < view.triangles.size(); ++t) {
    if (view.regions[t].front == view.regions[t].behind) continue;
    const auto& [a, b, c] = view.triangles[t];
    if ((border_of_vertex[a.index] & border_of_vertex[b.index] & border_of_vertex[c.index]) != none)
      near.push_back(t);
  }
  const auto each_corner = [&](auto&& function) {
    for (const std::uint32_t t : near) {
      for (const film::Vertex v : view.triangles[t]) function(t, v);
    }
  };
  each_corner([&](std::uint32_t t, film::Vertex v) {
    touch(v, view.regions[t].front);
    touch(v, view.regions[t].behind);
  });
  for (const FieldEdge& content : contents) {
    touch(content.from, content.region);
    touch(content.to, content.region);
  }
  for (const FixedRow& row : fixed) {
    for (const std::uint32_t v : row.vertices) touch_row(border_of_vertex[v], row.row);
  }
  for (std::size_t b = 0; b < borders_.size(); ++b) {
    std::sort(rows_at[b].begin(), rows_at[b].end());
    borders_[b].first = static_cast<std::uint32_t>(slot_rows_.size());
    for (const int row : rows_at[b]) slot_rows_.push_back(row);
    borders_[b].last = static_cast<std::uint32_t>(slot_rows_.size());
  }
  const auto slot = [&](film::Vertex v, film::Region region) {
    const std::uint32_t b = border_of_vertex[v.index];
    const int row = row_of_region[region.index];
    if (b == none || row < 0) return none;
    std::uint32_t s = borders_[b].first;
    while (slot_rows_[s] != row) ++s;
    return s;
  };
  each_corner([&](std::uint32_t t, film::Vertex v) {
    const film::RegionPair pair = sorted(view.regions[t]);
    const BorderCorner corner{t, slot(v, pair.behind), slot(v, pair.front)};
    if (corner.higher != none || corner.lower != none) corners_.push_back(corner);
  });
  for (const RimEdge& rim : rims) {
    if (row_of_region[rim.region.index] >= 0)
      rims_.push_back({rim, slot(rim.from, rim.region), slot(rim.to, rim.region)});
  }
  for (const FieldEdge& content : contents) {
    if (row_of_region[content.region.index] < 0) continue;
    contents_.push_back({content, slot(content.from, content.region), slot(content.to, content.region)});
  }
}

void VolumeGradient::build_pattern() {
  const auto each_entry = [&](auto&& function) {
    for (int i = 0; i < rows_; ++i) function(i, i);
    for (const Pair& pair : pairs_) {
      if (pair.high >= 0 && pair.low >= 0)
        function(std::max(pair.high, pair.low), std::min(pair.high, pair.low));
    }
    for (const BorderVertex& border : borders_) {
      for (std::uint32_t s = border.first; s < border.last; ++s) {
        for (std::uint32_t t = border.first; t <= s; ++t) function(slot_rows_[s], slot_rows_[t]);
      }
    }
  };
  // Columns by rows: the same ones come again and again, mostly soon.
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(rows_));
  each_entry([&](int row, int column) {
    std::vector<int>& of_row = columns[static_cast<std::size_t>(row)];
    const auto end =
        of_row.rend() - of_row.rbegin() > most_recent ? of_row.rbegin() + most_recent : of_row.rend();
    if (std::find(of_row.rbegin(), end, column) == end) of_row.push_back(column);
  });
  std::vector<std::size_t> first(columns.size() + 1, 0);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::sort(columns[i].begin(), columns[i].end());
    columns[i].erase(std::unique(columns[i].begin(), columns[i].end()), columns[i].end());
    for (const int column : columns[i]) pattern_.push_back({static_cast<int>(i), column});
    first[i + 1] = pattern_.size();
  }
  const auto entry = [&](int row, int column) {
    const auto of_row = static_cast<std::size_t>(std::max(row, column));
    const std::vector<int>& known = columns[of_row];
    const auto at = std::lower_bound(known.begin(), known.end(), std::min(row, column));
    return static_cast<int>(first[of_row] + static_cast<std::size_t>(at - known.begin()));
  };
  for (Pair& pair : pairs_) {
    if (pair.high >= 0) pair.entry_high = entry(pair.high, pair.high);
    if (pair.low >= 0) pair.entry_low = entry(pair.low, pair.low);
    if (pair.high >= 0 && pair.low >= 0) pair.entry_mixed = entry(pair.high, pair.low);
  }
  for (BorderVertex& border : borders_) {
    border.first_entry = static_cast<std::uint32_t>(border_entries_.size());
    for (std::uint32_t s = border.first; s < border.last; ++s) {
      for (std::uint32_t t = border.first; t <= s; ++t)
        border_entries_.push_back(entry(slot_rows_[s], slot_rows_[t]));
    }
  }
}

void VolumeGradient::update(const SweepInput& input, std::span<const VertexLine> lines, OpenVolume convention,
                            double time) {
  std::fill(next_slots_.begin(), next_slots_.end(), VolumeSlot{});
  std::uint32_t triangle = none;  // the corners of one follow each other
  Vec3 share;
  for (const BorderCorner& corner : corners_) {
    if (corner.triangle != triangle) {
      triangle = corner.triangle;
      const auto& v = input.triangles[triangle];
      const film::RegionPair pair = input.regions[triangle];
      share = double_area_vector(input.positions[v[0].index], input.positions[v[1].index],
                                 input.positions[v[2].index]) /
              (pair.front < pair.behind ? 6 : -6);
    }
    if (corner.higher != none) next_slots_[corner.higher].gradient += share;
    if (corner.lower != none) next_slots_[corner.lower].gradient -= share;
  }
  finish(input, lines, convention, time);
}

void VolumeGradient::finish(const SweepInput& input, std::span<const VertexLine> lines, OpenVolume convention,
                            double time) {
  lines_ = lines;
  unrestricted_.clear();
  std::swap(slots_, next_slots_);
  for (const Rim& rim : rims_) {
    const RimGradient g = rim_volume_gradient(input.positions[rim.edge.from.index],
                                              input.positions[rim.edge.to.index], input.origin, convention);
    slots_[rim.from].gradient += rim.edge.times * g.from;
    slots_[rim.to].gradient += rim.edge.times * g.to;
  }
  for (const Content& content : contents_) {
    const EdgeGradient g = edge_integral_gradient(content.edge, input.positions, time, order_);
    slots_[content.from].gradient += g.from;
    slots_[content.to].gradient += g.to;
  }
}

void VolumeGradient::set_fixed(int row, std::span<const Vec3> gradient) {
  for (const BorderVertex& border : borders_) {
    for (std::uint32_t s = border.first; s < border.last; ++s) {
      if (slot_rows_[s] == row) slots_[s].gradient = gradient[border.vertex];
    }
  }
}

void VolumeGradient::restrict(const VertexConstraints& constraints) {
  if (constraints.empty() || rows_ == 0) return;
  restricted_.resize(place_of_vertex_.size());
  for (std::uint32_t v = 0; v < place_of_vertex_.size(); ++v) {
    if (place_of_vertex_[v] < pairs_.size())
      restricted_[v] = constraints.restricted(v, lines_[v].area_vector);
  }
  if (unrestricted_.empty()) {
    for (const VolumeSlot& slot : slots_) unrestricted_.push_back(slot.gradient);
  }
  for (const BorderVertex& border : borders_) {
    if (!constraints.holds(border.vertex)) continue;
    for (std::uint32_t s = border.first; s < border.last; ++s) {
      slots_[s].gradient = constraints.restricted(border.vertex, unrestricted_[s]);
    }
  }
}

void VolumeGradient::gram(std::span<const double> weights, std::span<double> values) const {
  std::fill(values.begin(), values.end(), 0.0);
  // Inner vertices of one film mostly follow each other, so their sum is kept until the film changes.
  std::uint32_t run = none;
  double sum = 0;
  const auto flush = [&] {
    if (run == none) return;
    const Pair& pair = pairs_[run];
    if (pair.high >= 0) values[static_cast<std::size_t>(pair.entry_high)] += sum;
    if (pair.low >= 0) values[static_cast<std::size_t>(pair.entry_low)] += sum;
    if (pair.entry_mixed >= 0) values[static_cast<std::size_t>(pair.entry_mixed)] -= sum;
    sum = 0;
  };
  for (std::size_t v = 0; v < place_of_vertex_.size(); ++v) {
    const std::uint32_t pair = place_of_vertex_[v];
    if (pair >= pairs_.size()) continue;
    if (pair != run) {
      flush();
      run = pair;
    }
    sum += weights[v] * squared_length(area_vector(v));
  }
  flush();
  for (const BorderVertex& border : borders_) {
    const int* entry = border_entries_.data() + border.first_entry;
    for (std::uint32_t s = border.first; s < border.last; ++s) {
      for (std::uint32_t t = border.first; t <= s; ++t) {
        values[static_cast<std::size_t>(*entry++)] +=
            weights[border.vertex] * film::dot(slots_[s].gradient, slots_[t].gradient);
      }
    }
  }
}

void VolumeGradient::dot(std::span<const double> weights, std::span<const Vec3> field,
                         std::span<double> result) const {
  std::fill(result.begin(), result.end(), 0.0);
  std::uint32_t run = none;
  double sum = 0;
  const auto flush = [&] {
    if (run == none) return;
    if (pairs_[run].high >= 0) result[static_cast<std::size_t>(pairs_[run].high)] += sum;
    if (pairs_[run].low >= 0) result[static_cast<std::size_t>(pairs_[run].low)] -= sum;
    sum = 0;
  };
  for (std::size_t v = 0; v < place_of_vertex_.size(); ++v) {
    const std::uint32_t pair = place_of_vertex_[v];
    if (pair >= pairs_.size()) continue;
    if (pair != run) {
      flush();
      run = pair;
    }
    sum += weights[v] * film::dot(area_vector(v), field[v]);
  }
  flush();
  for (const BorderVertex& border : borders_) {
    for (std::uint32_t s = border.first; s < border.last; ++s) {
      result[static_cast<std::size_t>(slot_rows_[s])] +=
          weights[border.vertex] * film::dot(slots_[s].gradient, field[border.vertex]);
    }
  }
}

// The sums over neighbouring vertices inside one film.
void VolumeGradient::add_run(const RunSum& run, Products& products) const {
  const Pair& pair = pairs_[run.pair];
  const auto add = [&](int row, int entry, double sign) {
    if (row < 0) return;
    products.gram[static_cast<std::size_t>(entry)] += run.square;
    products.first[static_cast<std::size_t>(row)] += sign * run.first;
    products.second[static_cast<std::size_t>(row)] += sign * run.second;
  };
  add(pair.high, pair.entry_high, 1);
  add(pair.low, pair.entry_low, -1);
  if (pair.entry_mixed >= 0) products.gram[static_cast<std::size_t>(pair.entry_mixed)] -= run.square;
}

// The share of a border vertex.
void VolumeGradient::add_border(const BorderVertex& border, double weight, const Vec3& a, const Vec3& b,
                                Products& products) const {
  const int* entry = border_entries_.data() + border.first_entry;
  for (std::uint32_t s = border.first; s < border.last; ++s) {
    const Vec3& gradient = slots_[s].gradient;
    const auto row = static_cast<std::size_t>(slot_rows_[s]);
    products.first[row] += film::dot(gradient, a);
    products.second[row] += film::dot(gradient, b);
    const Vec3 weighted = weight * gradient;
    for (std::uint32_t t = border.first; t <= s; ++t)
      products.gram[static_cast<std::size_t>(*entry++)] += film::dot(weighted, slots_[t].gradient);
  }
}

void VolumeGradient::multiply_gram(std::span<const double> values, std::span<const double> vector,
                                   std::span<double> result) const {
  std::fill(result.begin(), result.end(), 0.0);
  for (std::size_t i = 0; i < pattern_.size(); ++i) {
    const auto row = static_cast<std::size_t>(pattern_[i].row);
    const auto column = static_cast<std::size_t>(pattern_[i].column);
    result[row] += values[i] * vector[column];
    if (row != column) result[column] += values[i] * vector[row];
  }
}

void VolumeGradient::factor_pairs(std::span<const double> multipliers, std::vector<double>& factors) const {
  factors.assign(pairs_.size(), 0.0);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].high >= 0) factors[i] += multipliers[static_cast<std::size_t>(pairs_[i].high)];
    if (pairs_[i].low >= 0) factors[i] -= multipliers[static_cast<std::size_t>(pairs_[i].low)];
  }
}

void VolumeGradient::set_multipliers(std::span<const double> multipliers) {
  multipliers_.assign(multipliers.begin(), multipliers.end());
  factor_pairs(multipliers, pair_factor_);
}

void VolumeGradient::set_multipliers(std::span<const double> first, std::span<const double> second) {
  set_multipliers(first);
  second_multipliers_.assign(second.begin(), second.end());
  factor_pairs(second, second_factor_);
}

Vec3 VolumeGradient::unrestricted_pull(std::size_t vertex) const {
  const std::uint32_t place = place_of_vertex_[vertex];
  if (place == none) return {};
  if (place < pairs_.size()) return pair_factor_[place] * lines_[vertex].area_vector;
  const BorderVertex& border = borders_[place - pairs_.size()];
  Vec3 sum;
  for (std::uint32_t s = border.first; s < border.last; ++s)
    sum += multipliers_[static_cast<std::size_t>(slot_rows_[s])] *
           (unrestricted_.empty() ? slots_[s].gradient : unrestricted_[s]);
  return sum;
}

Vec3 VolumeGradient::border_pull(const BorderVertex& border) const {
  Vec3 sum;
  for (std::uint32_t s = border.first; s < border.last; ++s) {
    sum += multipliers_[static_cast<std::size_t>(slot_rows_[s])] * slots_[s].gradient;
  }
  return sum;
}

std::pair<Vec3, Vec3> VolumeGradient::border_pulls(const BorderVertex& border) const {
  Vec3 first;
  Vec3 second;
  for (std::uint32_t s = border.first; s < border.last; ++s) {
    const auto row = static_cast<std::size_t>(slot_rows_[s]);
    first += multipliers_[row] * slots_[s].gradient;
    second += second_multipliers_[row] * slots_[s].gradient;
  }
  return {first, second};
}

}  // namespace lamella::energy
