#include "solve/dissection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lamella::solve {

namespace {

using film::Vec3;

constexpr int most_planes = 200;  // that are tried across an axis, and how many for so many rows
constexpr std::size_t rows_per_plane = 4;
// Seams are counted at about so many rows of a part, which tells good planes from bad ones as well as all do.
constexpr std::size_t counted = 4000;
// A part is cut across axes along which it is at least this part of its longest extent.
constexpr double long_enough = 0.6;
// Each side has at least this part of the rows; what a seam costs more for parts that are not equal.
constexpr double least_part = 0.2;
constexpr double lopsided = 1;

// Who is tied to whom, both ways.
struct Graph {
  std::vector<int> start;
  std::vector<int> neighbour;
};

Graph graph_of(const LowerMatrix& pattern, std::size_t rows) {
  Graph graph;
  graph.start.assign(rows + 1, 0);
  const auto each = [&](auto&& function) {
    for (std::size_t j = 0; j < rows; ++j) {
      const auto last = static_cast<std::size_t>(pattern.column_start[j + 1]);
      for (auto at = static_cast<std::size_t>(pattern.column_start[j]); at < last; ++at) {
        const auto i = static_cast<std::size_t>(pattern.row[at]);
        if (i != j && i < rows) function(i, j);
      }
    }
  };
  each([&](std::size_t i, std::size_t j) {
    ++graph.start[i + 1];
    ++graph.start[j + 1];
  });
  for (std::size_t i = 0; i < rows; ++i) graph.start[i + 1] += graph.start[i];
  graph.neighbour.resize(static_cast<std::size_t>(graph.start[rows]));
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  each([&](std::size_t i, std::size_t j) {
    graph.neighbour[static_cast<std::size_t>(next[i]++)] = static_cast<int>(j);
    graph.neighbour[static_cast<std::size_t>(next[j]++)] = static_cast<int>(i);
  });
  return graph;
}

// The plane where coordinate `axis` is `at`.
struct Cut {
  int axis = 0;
  double low = 0;  // planes stand at low + i/scale
  double scale = 0;
  int planes = 0;
  int plane = 0;
  double cost = HUGE_VAL;

  // The last plane at or below a place. Rounding decides where places are all but the same, and what is no
  // place lies below all planes.
  int plane_of(double x) const {
    const double at = (x - low) * scale;
    return at > 0 ? static_cast<int>(std::min(at, planes - 1.0)) : 0;
  }
  bool is_below(double x) const { return plane_of(x) < plane; }
};

class Dissector {
 public:
  Dissector(const LowerMatrix& pattern, std::span<const Vec3> places, std::size_t small)
      : pattern_(pattern),
        places_(places),
        small_(small),
        graph_(graph_of(pattern, places.size())),
        side_(places.size(), 0),
        partner_(places.size(), -1),
        seen_(places.size()),
        covered_(places.size()),
        piece_of_(static_cast<std::size_t>(pattern.size())) {}

  Dissection run();

 private:
  int part(std::span<int> rows);
  int seal(std::span<const int> rows);
  template <class Function>
  void for_each_tie(int row, int side, Function&& function) const;
  Vec3 extents(std::span<const int> rows, Vec3& low) const;
  Cut best_cut(std::span<const int> rows) const;
  Cut best_cut(std::span<const int> rows, int axis, double low, double extent) const;
  bool match(int row, int high);
  void reach(int row, int high);
  void cover(std::span<const int> rows, int high);
  void place_multipliers();
  Dissection numbered() const;

  const LowerMatrix& pattern_;
  std::span<const Vec3> places_;
  std::size_t small_;
  Graph graph_;
  std::vector<int> side_;  // a mark of the part that a row belongs to at present
  int next_side_ = 1;
  std::vector<int> partner_;
  std::vector<int> seen_;  // the last round that came by
  int round_ = 0;
  std::vector<std::uint8_t> covered_;
  std::vector<int> parent_;  // of each piece
  std::vector<int> piece_of_;
};

int Dissector::seal(std::span<const int> rows) {
  for (const int row : rows) piece_of_[static_cast<std::size_t>(row)] = static_cast<int>(parent_.size());
  parent_.push_back(-1);
  return static_cast<int>(parent_.size()) - 1;
}

template <class Function>
void Dissector::for_each_tie(int row, int side, Function&& function) const {
  const auto first = static_cast<std::size_t>(graph_.start[static_cast<std::size_t>(row)]);
  const auto last = static_cast<std::size_t>(graph_.start[static_cast<std::size_t>(row) + 1]);
  for (std::size_t i = first; i < last; ++i) {
    const int other = graph_.neighbour[i];
    if (side_[static_cast<std::size_t>(other)] == side && function(other)) return;
  }
}

// Finds a partner in `high` for a row of the low side, where others may have to take another one.
bool Dissector::match(int row, int high) {
  bool found = false;
  for_each_tie(row, high, [&](int other) {
    if (std::exchange(seen_[static_cast<std::size_t>(other)], round_) == round_) return false;
    int& partner = partner_[static_cast<std::size_t>(other)];
    if (partner >= 0 && !match(partner, high)) return false;
    partner = row;
    partner_[static_cast<std::size_t>(row)] = other;
    return found = true;
  });
  return found;
}

// Marks what an alternating path from a row of the low side without a partner reaches.
void Dissector::reach(int row, int high) {
  covered_[static_cast<std::size_t>(row)] = 0;
  for_each_tie(row, high, [&](int other) {
    if (std::exchange(covered_[static_cast<std::size_t>(other)], 1) == 1) return false;
    const int partner = partner_[static_cast<std::size_t>(other)];
    if (covered_[static_cast<std::size_t>(partner)] == 1) reach(partner, high);
    return false;
  });
}

// Marks the fewest rows without which the two sides have no ties (D. Koenig's theorem: as many as there are
// rows of one side that can each be matched with another row of the other).
void Dissector::cover(std::span<const int> rows, int high) {
  std::vector<int> seam;
  for (const int row : rows) {
    bool tied = false;
    for_each_tie(row, high, [&](int) { return tied = true; });
    if (tied) seam.push_back(row);
  }
  for (const int row : seam) {
    ++round_;
    match(row, high);
  }
  for (const int row : seam) covered_[static_cast<std::size_t>(row)] = 1;
  for (const int row : seam) {
    if (partner_[static_cast<std::size_t>(row)] < 0) reach(row, high);
  }
}

Vec3 Dissector::extents(std::span<const int> rows, Vec3& low) const {
  low = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 high = -low;
  for (const int row : rows) {
    const Vec3& place = places_[static_cast<std::size_t>(row)];
    low = {std::min(low.x, place.x), std::min(low.y, place.y), std::min(low.z, place.z)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y), std::max(high.z, place.z)};
  }
  return high - low;
}

// The best across all axes; without a cost where there is none.
Cut Dissector::best_cut(std::span<const int> rows) const {
  Vec3 low;
  const Vec3 extent = extents(rows, low);
  const double longest = std::max({extent.x, extent.y, extent.z});
  Cut best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(extent[axis] >= long_enough * longest)) continue;
    const Cut cut = best_cut(rows, axis, low[axis], extent[axis]);
    if (cut.cost < best.cost) best = cut;
  }
  return best;
}

// How many rows lie below each of many planes across one axis, and how many of those are tied to rows above.
Cut Dissector::best_cut(std::span<const int> rows, int axis, double low, double extent) const {
  const auto at = [&](int row) { return places_[static_cast<std::size_t>(row)][axis]; };
  const int planes = static_cast<int>(std::min<std::size_t>(most_planes, rows.size() / rows_per_plane));
  const double scale = planes / extent;
  if (!(extent > 0) || !std::isfinite(scale)) return {};
  Cut best{axis, low, scale, planes};
  std::array<int, most_planes + 1> below;
  std::array<int, most_planes + 1> seam;
  std::fill_n(below.begin(), planes + 1, 0);
  std::fill_n(seam.begin(), planes + 1, 0);
  const std::size_t stride = std::max<std::size_t>(1, rows.size() / counted);
  int whole = 0;
  for (std::size_t i = 0; i < rows.size(); i += stride, ++whole) {
    const int row = rows[i];
    const int own = best.plane_of(at(row));
    int farthest = own;
    for_each_tie(row, side_[static_cast<std::size_t>(row)], [&](int other) {
      farthest = std::max(farthest, best.plane_of(at(other)));
      return false;
    });
    ++below[static_cast<std::size_t>(own) + 1];
    ++seam[static_cast<std::size_t>(own) + 1];
    --seam[static_cast<std::size_t>(farthest) + 1];
  }
  for (std::size_t i = 1; i < static_cast<std::size_t>(planes); ++i) {
    below[i] += below[i - 1];
    seam[i] += seam[i - 1];
    const double part = static_cast<double>(below[i]) / whole;
    if (part < least_part || part > 1 - least_part) continue;
    const double cost = seam[i] * (1 + lopsided * (2 * part - 1) * (2 * part - 1));
    if (!(cost < best.cost)) continue;
    best.plane = static_cast<int>(i);
    best.cost = cost;
  }
  return best;
}

// Numbers the pieces of some rows, the seam between its parts last. Returns that number.
int Dissector::part(std::span<int> rows) {
  if (rows.size() <= small_) return seal(rows);
  const Cut cut = best_cut(rows);
  if (cut.cost == HUGE_VAL) return seal(rows);
  const auto parted = std::partition(rows.begin(), rows.end(), [&](int row) {
    return cut.is_below(places_[static_cast<std::size_t>(row)][cut.axis]);
  });
  const int low = next_side_++;
  const int high = next_side_++;
  for (auto i = rows.begin(); i != rows.end(); ++i)
    side_[static_cast<std::size_t>(*i)] = i < parted ? low : high;
  cover(std::span<const int>(rows.begin(), parted), high);
  const auto in_seam = [&](int row) { return covered_[static_cast<std::size_t>(row)] != 0; };
  const auto low_end = std::partition(rows.begin(), parted, [&](int row) { return !in_seam(row); });
  const auto high_end = std::partition(parted, rows.end(), in_seam);
  const std::span<int> seam(low_end, high_end);
  const std::span<int> first(rows.begin(), low_end);
  const std::span<int> second(high_end, rows.end());
  for (const int row : rows) {
    covered_[static_cast<std::size_t>(row)] = 0;
    partner_[static_cast<std::size_t>(row)] = -1;
  }
  for (const int row : seam) side_[static_cast<std::size_t>(row)] = -1;
  std::array<int, 2> below{-1, -1};
  if (!first.empty()) below[0] = part(first);
  if (!second.empty()) below[1] = part(second);
  const int piece = seal(seam);
  for (const int part : below) {
    if (part >= 0) parent_[static_cast<std::size_t>(part)] = piece;
  }
  return piece;
}

// Multipliers go between the lowest piece that is above all the pieces of the rows they are tied to, and its
// parent.
void Dissector::place_multipliers() {
  std::vector<int> highest(piece_of_.size() - places_.size(), -1);
  for (std::size_t j = 0; j < places_.size(); ++j) {
    const auto last = static_cast<std::size_t>(pattern_.column_start[j + 1]);
    for (auto at = static_cast<std::size_t>(pattern_.column_start[j]); at < last; ++at) {
      const auto i = static_cast<std::size_t>(pattern_.row[at]);
      if (i < places_.size()) continue;
      int& a = highest[i - places_.size()];
      int b = piece_of_[j];
      if (a < 0) a = b;
      while (a != b) (a < b ? a : b) = parent_[static_cast<std::size_t>(std::min(a, b))];
    }
  }
  const int last = static_cast<int>(parent_.size()) - 1;
  for (std::size_t i = 0; i < highest.size(); ++i)
    piece_of_[places_.size() + i] = highest[i] < 0 ? last : highest[i];
}

// Splits off the multipliers of each piece.
Dissection Dissector::numbered() const {
  const std::size_t count = parent_.size();
  std::vector<std::uint8_t> has_multipliers(count);
  for (std::size_t i = places_.size(); i < piece_of_.size(); ++i)
    has_multipliers[static_cast<std::size_t>(piece_of_[i])] = 1;
  std::vector<int> number(count);
  Dissection result;
  for (std::size_t p = 0; p < count; ++p) {
    number[p] = static_cast<int>(result.parent.size());
    result.parent.push_back(number[p] + 1);  // its multipliers
    if (has_multipliers[p] != 0) result.parent.push_back(-1);
  }
  for (std::size_t p = 0; p < count; ++p) {
    const auto own = static_cast<std::size_t>(number[p] + has_multipliers[p]);
    result.parent[own] = parent_[p] < 0 ? -1 : number[static_cast<std::size_t>(parent_[p])];
  }
  for (std::size_t i = 0; i < piece_of_.size(); ++i) {
    const auto p = static_cast<std::size_t>(piece_of_[i]);
    result.piece.push_back(number[p] + (i < places_.size() ? 0 : has_multipliers[p]));
  }
  return result;
}

Dissection Dissector::run() {
  std::vector<int> rows(places_.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<int>(i);
  part(rows);
  place_multipliers();
  return numbered();
}

}  // namespace

Dissection dissection(const LowerMatrix& pattern, std::span<const Vec3> places, std::size_t small) {
  return Dissector(pattern, places, small).run();
}

}  // namespace lamella::solve
