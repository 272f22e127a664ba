#include "surgery/tangle_watch.h"

#include <algorithm>
#include <cmath>

#include "film/intersections.h"
#include "surgery/sizing.h"
#include "surgery/wedge.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// The way that a facet gets beyond what is listed, in units of its longest side.
constexpr double longest_way = 0.25;
// Where more than this part of the facets have used up their ways all are listed anew: facets that lie side
// by side are found together.
constexpr double most_alone = 0.2;
// Films at an edge cannot change places before the edges of a facet have changed by this part of its altitude
// times the distance of unit vectors across the edge.
constexpr double part_of_altitude = 0.15;
// A sheet is flat around a vertex where the normals of its facets turn from their mean by less than what this
// is the cosine of (37 degrees).
constexpr double flat_cosine = 0.8;
constexpr double least_cosine = 0.94;  // 20 degrees
constexpr std::size_t most_in_fan = 32;
constexpr std::uint32_t most_stamps = 1U << 31U;  // before vertices are marked from the beginning again

double longest_side(const Corners& p) {
  return std::sqrt(
      std::max({squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])}));
}

// By how much the edges of a facet may change before its normal has turned to 80 degrees from an axis, in
// units of its smallest altitude: no more than tan(b)/(1 + tan(b)), where b is what is left to that.
double room_to_turn(double cosine) {
  return 0.45 + 0.25 * (cosine - flat_cosine) / (1 - flat_cosine);
}

Tangle corners_of_both(const Film& film, Triangle a, Triangle b) {
  Tangle corners(film.corners(a).begin(), film.corners(a).end());
  corners.insert(corners.end(), film.corners(b).begin(), film.corners(b).end());
  return corners;
}

int shared_corners(const std::array<Vertex, 3>& a, const std::array<Vertex, 3>& b) {
  int count = 0;
  for (const Vertex v : a) count += v == b[0] || v == b[1] || v == b[2] ? 1 : 0;
  return count;
}

}  // namespace

// Facets that are not what they were are looked at, and everything if the film is another. Returns whether it
// is.
bool TangleWatch::adopt(const Film& film) {
  const std::vector<std::array<Vertex, 3>>& corners = film.connectivity().triangle_vertices;
  if (corners_.size() != corners.size() || last_.size() != film.vertex_rows()) {
    corners_ = corners;
    edges_.assign(corners.size(), 0);
    listed_at_.assign(corners.size(), {});
    listed_for_.assign(corners.size(), 0);
    pairs_.clear();
    flat_.assign(film.vertex_rows(), 0);
    last_.assign(film.positions().begin(), film.positions().end());
    return true;
  }
  for (std::size_t t = 0; t < corners.size(); ++t) {
    if (corners_[t] == corners[t]) continue;
    corners_[t] = corners[t];
    edges_[t] = listed_for_[t] = 0;
  }
  return false;
}

void TangleWatch::spend(const Film& film, std::span<const double> reaches) {
  const std::span<const Vec3> now = film.positions();
  reach_.assign(now.size(), 0);
  for (std::size_t v = 0; v < std::min(now.size(), last_.size()); ++v) reach_[v] = length(now[v] - last_[v]);
  if (reaches.size() == now.size()) {
    for (std::size_t v = 0; v < now.size(); ++v) reach_[v] = std::max(reach_[v], reaches[v]);
  }
  way_.assign(corners_.size(), 0);
  for (std::uint32_t t = 0; t < corners_.size(); ++t) {
    const auto& [a, b, c] = corners_[t];
    way_[t] = std::max({reach_[a.index], reach_[b.index], reach_[c.index]});
    if (!(way_[t] > 0)) continue;
    const Vec3 moves[3] = {now[a.index] - last_[a.index], now[b.index] - last_[b.index],
                           now[c.index] - last_[c.index]};
    edges_[t] -= std::sqrt(std::max({squared_length(moves[0] - moves[1]), squared_length(moves[1] - moves[2]),
                                     squared_length(moves[2] - moves[0])}));
  }
  for (FacetPair& pair : pairs_) pair.gap -= way_[pair.a.index] + way_[pair.b.index];
}

// How far a facet may yet go before what is near it is listed anew, wherever it has been since the last call.
double TangleWatch::way_left(Triangle t) const {
  const auto& [a, b, c] = corners_[t.index];
  const Corners& at = listed_at_[t.index];
  const double square =
      std::max({squared_length(last_[a.index] - at[0]), squared_length(last_[b.index] - at[1]),
                squared_length(last_[c.index] - at[2])});
  return listed_for_[t.index] - std::sqrt(square) - way_[t.index];
}

// Whether a facet's normal has turned by more than 20 degrees since it was listed: facets of its sheet may
// face it then. What has not moved has not turned.
bool TangleWatch::has_turned(const Film& film, Triangle t) const {
  const film::RegionPair regions = film.regions(t);
  if (regions.front == regions.behind || !(way_[t.index] > 0)) return false;
  const auto normal = [](const Corners& p) { return cross(p[1] - p[0], p[2] - p[0]); };
  const Vec3 before = normal(listed_at_[t.index]);
  const Vec3 now = normal(film.points(t));
  const double cosine = dot(before, now);
  return !(cosine > 0 &&
           cosine * cosine > least_cosine * least_cosine * squared_length(before) * squared_length(now));
}

// Which facets are looked at.
void TangleWatch::choose(const Film& film) {
  const std::span<const double> sizes = film.columns(film::ElementKind::vertex).reals(size_column);
  stretched_.clear();
  moved_.clear();
  due_.assign(corners_.size(), {});
  for (std::uint32_t t = 0; t < corners_.size(); ++t) {
    const auto& [a, b, c] = corners_[t];
    const double size = sizes.empty() ? 0 : std::max({sizes[a.index], sizes[b.index], sizes[c.index]});
    due_[t] = {!(edges_[t] > 0), !(listed_for_[t] > 0 && way_left(Triangle(t)) > listed_reach * size) ||
                                     has_turned(film, Triangle(t))};
    if (due_[t].edges) stretched_.emplace_back(t);
    if (due_[t].way) moved_.emplace_back(t);
  }
}

std::vector<Tangle> TangleWatch::look(const Film& film, std::span<const double> reaches) {
  const bool is_another = adopt(film);
  if (!goes_on_) look_at_all_again();
  spend(film, reaches);
  choose(film);
  std::vector<Tangle> found;
  looked_at_ += static_cast<long>(stretched_.size());
  look_around(film, found);
  look_at_borders(film, found);
  list_anew(film);
  looked_at_ += static_cast<long>(moved_.size());
  look_at_pairs(film, found);
  positions_ = film.position_revision();
  connectivity_ = film.connectivity_revision();
  if (found.empty())
    last_.assign(film.positions().begin(), film.positions().end());
  else
    goes_on_ = false;
  if (!found.empty() && is_another) forget();  // nobody goes on from where it tangles
  return united(film, found);
}

// The last call was about a film that nobody goes on from: what it found of gaps and angles is not so.
void TangleWatch::look_at_all_again() {
  std::fill(edges_.begin(), edges_.end(), 0.0);
  for (FacetPair& pair : pairs_) pair.gap = 0;
  goes_on_ = true;
}

// Facets whose edges have changed, and those that have a corner in common with them. First all get what they
// may have at most, so that each vertex and each pair can take from it.
void TangleWatch::look_around(const Film& film, std::vector<Tangle>& found) {
  if (stamps_ > most_stamps) stamp_.clear();
  if (stamp_.empty()) stamps_ = 0;
  stamp_.resize(std::max<std::size_t>(stamp_.size(), film.vertex_rows()));
  stamps_ += 2;
  for (const Triangle t : stretched_) edges_[t.index] = longest_side(film.points(t));
  for (const Triangle t : stretched_) {
    for (const Vertex v : film.corners(t)) {
      if (stamp_[v.index] == stamps_) continue;
      stamp_[v.index] = stamps_;
      look_at_vertex(film, v);
    }
  }
  borders_.clear();
  for (const Triangle t : stretched_) {
    // Pairs of two that are looked at are so once.
    const auto was_compared = [&](Triangle other) { return due_[other.index].edges && other < t; };
    for (const Vertex v : film.corners(t)) {
      if (flat_[v.index] != 0) continue;
      film.for_each_end(v, [&](EdgeEnd end) {
        film.for_each_side(end.edge(), [&](Side s) {
          // Once at each corner that they share; twice where they share two.
          if (s.triangle() != t && film.tail(film.edge_of(s)) == v && !was_compared(s.triangle()))
            compare_at_corner(film, t, s.triangle(), found);
        });
      });
    }
    for (const film::SignedEdge e : film.edges(t)) {
      if (film.valence(e.edge()) > 2) borders_.push_back(e.edge());
    }
  }
}

// Facets around a vertex that is no longer flat are to be listed with all that is near them.
void TangleWatch::look_at_vertex(const Film& film, Vertex v) {
  const bool was_flat = flat_[v.index] != 0;
  flat_[v.index] = find_flat(film, v) ? 1 : 0;
  if (!was_flat || flat_[v.index] != 0) return;
  film.for_each_end(v, [&](EdgeEnd end) {
    film.for_each_side(end.edge(), [&](Side s) {
      Due& due = due_[s.triangle().index];
      if (!due.way) moved_.push_back(s.triangle());
      due.way = true;
    });
  });
}

// Whether the facets at a vertex go once around it in one sheet, their normals near a mean. Then a plane
// shows them side by side, and does so until one of the normals has turned by a right angle from that mean.
bool TangleWatch::find_flat(const Film& film, Vertex v) {
  const EdgeEnd first = film.first_end(v);
  if (film.periodic() || !first.valid() || !film.first_side(first.edge()).valid()) return false;
  ring_.clear();
  Side s = film.first_side(first.edge());
  Vec3 axis;
  do {
    const Triangle t = s.triangle();
    const film::SignedEdge edge = film.edge_of(s);
    const bool leads_out = film.tail(edge) == v;
    ring_.push_back({t, film.position(leads_out ? film.head(edge) : film.tail(edge)) - film.position(v)});
    const Side other(t, leads_out ? film::previous_corner(s.corner()) : film::next_corner(s.corner()));
    s = film.next_around(other);
    if (s == other || film.next_around(s) != other || ring_.size() > most_in_fan) return false;
  } while (film.edge_of(s).edge() != first.edge());
  std::size_t ends = 0;
  film.for_each_end(v, [&](EdgeEnd) { ++ends; });
  if (ends != ring_.size()) return false;
  const auto after = [&](std::size_t i) -> const Vec3& { return ring_[i + 1 < ends ? i + 1 : 0].to; };
  for (std::size_t i = 0; i < ends; ++i) axis += unit(cross(ring_[i].to, after(i)));
  axis = unit(axis);
  const Vec3 upward = cross(axis, ring_[0].to + 0.5 * after(0));
  int turns = 0;
  for (std::size_t i = 0; i < ends; ++i) {
    const Vec3 normal = cross(ring_[i].to, after(i));
    if (!(dot(normal, axis) > flat_cosine * length(normal))) return false;
    if (dot(upward, ring_[i].to) < 0 && dot(upward, after(i)) >= 0) ++turns;
  }
  if (turns != 1) return false;
  for (std::size_t i = 0; i < ends; ++i) {
    const Vec3 normal = cross(ring_[i].to, after(i));
    const double twice = length(normal);
    const double longest = longest_side({Vec3{}, ring_[i].to, after(i)});
    double& left = edges_[ring_[i].facet.index];
    left = std::min(left, twice / longest * room_to_turn(dot(normal, axis) / twice));
  }
  return true;
}

void TangleWatch::compare_at_corner(const Film& film, Triangle t, Triangle other,
                                    std::vector<Tangle>& found) {
  const int shared = shared_corners(film.corners(t), film.corners(other));
  const std::array<double, 2> room =
      shared == 1 ? room_at_corner(film, t, other) : room_at_edge(film, t, other, part_of_altitude);
  double& own = edges_[t.index];
  double& others = edges_[other.index];
  own = std::min(own, room[0]);
  others = std::min(others, room[1]);
  if (std::min(room[0], room[1]) > 0) return;
  if (film::facets_cross(film, t, other)) found.push_back(corners_of_both(film, t, other));
}

void TangleWatch::look_at_borders(const Film& film, std::vector<Tangle>& found) {
  std::sort(borders_.begin(), borders_.end());
  borders_.erase(std::unique(borders_.begin(), borders_.end()), borders_.end());
  for (const Edge e : borders_) {
    if (!is_out_of_order(film, e)) continue;
    Tangle part(film.ends(e).begin(), film.ends(e).end());
    film.for_each_side(e, [&](Side s) { part.push_back(film.opposite(s)); });
    found.push_back(std::move(part));
  }
}

// From where a facet is now.
void TangleWatch::list(const Film& film, Triangle t) {
  const std::span<const double> sizes = film.columns(film::ElementKind::vertex).reals(size_column);
  const auto& [a, b, c] = corners_[t.index];
  const double size = sizes.empty() ? 0 : std::max({sizes[a.index], sizes[b.index], sizes[c.index]});
  listed_at_[t.index] = film.points(t);
  listed_for_[t.index] = longest_way * longest_side(listed_at_[t.index]) + listed_reach * size;
}

// Marks a facet's corners and, if those are flat, the vertices next to them.
void TangleWatch::stamp_ring(const Film& film, Triangle t) {
  stamps_ += 2;
  const auto& corners = film.corners(t);
  if (std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return flat_[v.index] != 0; })) {
    for (const Vertex v : corners)
      film.for_each_end(v, [&](EdgeEnd end) { stamp_[film.head(end.outward()).index] = stamps_; });
  }
  for (const Vertex v : corners) stamp_[v.index] = stamps_ + 1;
}

// Whether a facet has a corner in common with the one whose ring is marked, or lies in one flat sheet with it
// and next to it.
bool TangleWatch::is_neighbour(Triangle other) const {
  bool is_next = false;
  bool is_flat = true;
  for (const Vertex v : corners_[other.index]) {
    if (stamp_[v.index] == stamps_ + 1) return true;
    is_next = is_next || stamp_[v.index] == stamps_;
    is_flat = is_flat && flat_[v.index] != 0;
  }
  return is_next && is_flat;
}

// The pairs of those facets that have used up their way.
void TangleWatch::list_anew(const Film& film) {
  if (moved_.empty()) return;
  if (static_cast<double>(moved_.size()) > most_alone * static_cast<double>(corners_.size())) {
    moved_.clear();
    for (std::uint32_t t = 0; t < corners_.size(); ++t) {
      moved_.emplace_back(t);
      due_[t].way = true;
    }
  }
  std::erase_if(pairs_,
                [&](const FacetPair& pair) { return due_[pair.a.index].way || due_[pair.b.index].way; });
  asked_.clear();
  for (const Triangle t : moved_) {
    list(film, t);
    asked_.push_back(film::box_of(listed_at_[t.index], listed_for_[t.index]));
  }
  cells_.make(listed_at_, listed_for_, film.connectivity().triangle_regions);
  Triangle at;
  cells_.for_each_near(moved_, asked_, [&](std::uint32_t i, Triangle other) {
    const Triangle t = moved_[i];
    if (other == t || (due_[other.index].way && other < t)) return;
    if (at != t) stamp_ring(film, t);
    at = t;
    if (is_neighbour(other)) return;
    if (gap_at_least(listed_at_[t.index], listed_at_[other.index]) <
        listed_for_[t.index] + listed_for_[other.index])
      pairs_.push_back({t, other, 0});
  });
}

// Those whose gap is used up.
void TangleWatch::look_at_pairs(const Film& film, std::vector<Tangle>& found) {
  for (FacetPair& pair : pairs_) {
    if (pair.gap > 0) continue;
    pair.gap = std::max(0.0, gap_at_least(film.points(pair.a), film.points(pair.b)));
    if ((pair.gap <= 0 && film::facets_cross(film, pair.a, pair.b)) || have_met(film, pair.a, pair.b))
      found.push_back(corners_of_both(film, pair.a, pair.b));
  }
}

// Whether two facets have met on the way since the last look.
bool TangleWatch::have_met(const Film& film, Triangle t, Triangle other) const {
  Corners before[2];
  double way[2] = {};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::array<Vertex, 3>& corners = film.corners(i == 0 ? t : other);
    for (std::size_t k = 0; k < 3; ++k) {
      before[i][k] = last_[corners[k].index];
      way[i] = std::max(way[i], reach_[corners[k].index]);
    }
  }
  if (way[0] + way[1] <= 0 || gap_at_least(before[0], before[1]) > way[0] + way[1]) return false;
  return meet_on_the_way(before[0], film.points(t), before[1], film.points(other));
}

// New rows are those of what is alive, in order. Facets that were made since, or have other corners now, have
// nothing left. What surgery has moved has spent its way, and is followed no further.
void TangleWatch::before_compaction(const Film& film) {
  const auto& corners = film.connectivity().triangle_vertices;
  spend(film, {});
  flat_.resize(film.vertex_rows());
  std::vector<Vertex> row(film.vertex_rows());
  std::vector<std::uint8_t> flat;
  last_.clear();
  for (std::uint32_t v = 0; v < row.size(); ++v) {
    if (!film.alive(Vertex(v))) continue;
    row[v] = Vertex(static_cast<std::uint32_t>(last_.size()));
    last_.push_back(film.position(Vertex(v)));
    flat.push_back(flat_[v]);
  }
  std::vector<std::array<Vertex, 3>> kept;
  std::vector<double> edges;
  std::vector<Corners> listed_at;
  std::vector<double> listed_for;
  std::vector<Triangle> facet(corners.size());  // of those that are what they were
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    if (!film.alive(Triangle(t))) continue;
    const bool same = t < corners_.size() && corners_[t] == corners[t];
    if (same) facet[t] = Triangle(static_cast<std::uint32_t>(kept.size()));
    edges.push_back(same ? edges_[t] : 0);
    listed_at.push_back(same ? listed_at_[t] : Corners{});
    listed_for.push_back(same ? listed_for_[t] : 0);
    kept.push_back({row[corners[t][0].index], row[corners[t][1].index], row[corners[t][2].index]});
  }
  std::erase_if(pairs_, [&](FacetPair& pair) {
    pair = {facet[pair.a.index], facet[pair.b.index], pair.gap};
    return !pair.a.valid() || !pair.b.valid();
  });
  edges_ = std::move(edges);
  listed_at_ = std::move(listed_at);
  listed_for_ = std::move(listed_for);
  flat_ = std::move(flat);
  corners_ = std::move(kept);
}

}  // namespace lamella::surgery
