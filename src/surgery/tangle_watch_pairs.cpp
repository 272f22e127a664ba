#include <algorithm>
#include <cmath>

#include "film/intersections.h"
#include "surgery/sizing.h"
#include "surgery/tangle_watch.h"

namespace lamella::surgery {

using film::EdgeEnd;
using film::Film;
using film::Triangle;
using film::Vertex;

namespace {

// The way that a facet gets beyond what is listed, in units of its longest side.
constexpr double longest_way = 0.25;
constexpr double times_alone = 4;  // as far, where there is nothing near it but its own sheet

}  // namespace

// From where a facet is now, for a multiple of the usual way.
void TangleWatch::list(const Film& film, Triangle t, double times) {
  const std::span<const double> sizes = film.columns(film::ElementKind::vertex).reals(size_column);
  const auto& [a, b, c] = corners_[t.index];
  const double size = sizes.empty() ? 0 : std::max({sizes[a.index], sizes[b.index], sizes[c.index]});
  listed_at_[t.index] = film.points(t);
  listed_for_[t.index] = times * longest_way * longest_side(listed_at_[t.index]) + listed_reach * size;
}

// Marks a facet's corners and, if those are flat, the vertices next to them.
void TangleWatch::stamp_ring(const Film& film, Triangle t) {
  stamps_ += 2;
  const auto& corners = film.corners(t);
  if (std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return is_flat(v); })) {
    for (const Vertex v : corners)
      film.for_each_end(v, [&](EdgeEnd end) { stamp_[film.head(end.outward()).index] = stamps_; });
  }
  for (const Vertex v : corners) stamp_[v.index] = stamps_ + 1;
}

// Whether a facet has a corner in common with the one whose ring is marked, or lies in one flat sheet with it
// and next to it: as long as neither has turned by more than 20 degrees.
bool TangleWatch::is_neighbour(Triangle t, Triangle other) const {
  bool is_next = false;
  bool are_flat = true;
  for (const Vertex v : corners_[other.index]) {
    if (stamp_[v.index] == stamps_ + 1) return true;
    is_next = is_next || stamp_[v.index] == stamps_;
    are_flat = are_flat && is_flat(v);
  }
  return is_next && are_flat && cells_.are_one_way(t, other);
}

// The pairs of those facets that have used up their way. One that was alone is listed for a longer way: if it
// is so again, that is all.
void TangleWatch::list_anew(const Film& film, std::vector<Tangle>& found) {
  if (2 * moved_.size() > corners_.size()) make_cells(film);
  for (const Triangle t : moved_) {
    list(film, t, alone_[t.index] != 0 ? times_alone : 1);
    put(film, t);
  }
  cells_.order(moved_);
  for (const Triangle t : moved_) {
    if (alone_[t.index] != 0 && cells_.is_alone(t)) continue;
    if (alone_[t.index] != 0) {
      list(film, t, 1);
      put(film, t);
    }
    alone_[t.index] = cells_.is_alone(t) ? 1 : 0;
    if (alone_[t.index] == 0) list_near(film, t, found);
  }
}

// The pairs of a facet with those that are not listed anew, or come after it.
void TangleWatch::list_near(const Film& film, Triangle t, std::vector<Tangle>& found) {
  stamp_ring(film, t);
  cells_.for_each_near(t, [&](Triangle other) {
    if ((due_[other.index].way && other < t) || is_neighbour(t, other)) return;
    FacetPair pair{t, other, gap_at_least(listed_at_[t.index], film.points(other))};
    if (cannot_meet(film, pair)) return;
    look_at_pair(film, pair, found);
    measured_.push_back(pairs_.size());
    pairs_.push_back(pair);
  });
}

// Whether two facets cannot meet while their lists serve. The first is where it was listed; the second may be
// on its way, and its gap from here does not tell what it was from there.
bool TangleWatch::cannot_meet(const Film& film, const FacetPair& pair) const {
  const double both = listed_for_[pair.a.index] + listed_for_[pair.b.index];
  if (due_[pair.b.index].way) return pair.gap >= both;
  const Corners p = film.points(pair.b);
  const Corners& at = listed_at_[pair.b.index];
  const double way = std::sqrt(
      std::max({squared_length(p[0] - at[0]), squared_length(p[1] - at[1]), squared_length(p[2] - at[2])}));
  return pair.gap >= both + way ||
         (pair.gap >= both - way && gap_at_least(listed_at_[pair.a.index], at) >= both);
}

void TangleWatch::make_cells(const Film& film) {
  double sum = 0;
  for (const Triangle t : moved_) {
    list(film, t, 1);
    sum += 0.5 * longest_side(listed_at_[t.index]) + listed_for_[t.index];
  }
  cells_.begin(corners_.size(), sum / static_cast<double>(moved_.size()));
  for (std::uint32_t t = 0; t < corners_.size(); ++t) {
    if (!due_[t].way) put(film, Triangle(t));
  }
}

void TangleWatch::put(const Film& film, Triangle t) {
  cells_.put(t, listed_at_[t.index], listed_for_[t.index], film.regions(t));
}

// Pairs of facets that are listed anew are made anew; of the others those are looked at whose gap is used up.
void TangleWatch::look_at_pairs(const Film& film, std::vector<Tangle>& found) {
  measured_.clear();
  std::size_t kept = 0;
  for (FacetPair pair : pairs_) {
    if (due_[pair.a.index].way || due_[pair.b.index].way) continue;
    pair.gap -= way_[pair.a.index] + way_[pair.b.index];
    if (!(pair.gap > 0)) {
      pair.gap = gap_at_least(film.points(pair.a), film.points(pair.b));
      look_at_pair(film, pair, found);
      measured_.push_back(kept);
    }
    pairs_[kept++] = pair;
  }
  pairs_.resize(kept);
}

// One whose gap was measured now.
void TangleWatch::look_at_pair(const Film& film, FacetPair& pair, std::vector<Tangle>& found) {
  pair.gap = std::max(0.0, pair.gap);
  if ((pair.gap <= 0 && film::facets_cross(film, pair.a, pair.b)) || have_met(film, pair))
    found.push_back(corners_of(film, pair.a, pair.b));
}

// Whether two facets, now so far apart, have met on the way since the last look.
bool TangleWatch::have_met(const Film& film, const FacetPair& pair) const {
  const double way = way_[pair.a.index] + way_[pair.b.index];
  if (way <= 0 || pair.gap > way) return false;
  const auto before = [&](Triangle t) {
    const auto& [a, b, c] = corners_[t.index];
    return Corners{last_[a.index], last_[b.index], last_[c.index]};
  };
  const Corners a = before(pair.a);
  const Corners b = before(pair.b);
  return gap_at_least(a, b) <= way && meet_on_the_way(a, film.points(pair.a), b, film.points(pair.b));
}

}  // namespace lamella::surgery
