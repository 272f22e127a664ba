#include "surgery/tangle_watch.h"

#include <algorithm>
#include <cmath>

#include "film/intersections.h"
#include "surgery/facet_gap.h"
#include "surgery/wedge.h"

namespace lamella::surgery {

using film::Box;
using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// The way that a facet gets at most, in units of its longest side.
constexpr double longest_way = film::FacetCells::margin;
// Films at an edge cannot change places before the edges of a facet have changed by this part of its altitude
// times the angle between them (at most 1 rad).
constexpr double part_of_altitude = 0.15;

double longest_side(const Corners& p) {
  return std::sqrt(
      std::max({squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])}));
}

Box widened_box(const Corners& p) {
  return film::box_of(p, longest_way * longest_side(p));
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
    left_.assign(corners.size(), {});
    last_.assign(film.positions().begin(), film.positions().end());
    return true;
  }
  for (std::size_t t = 0; t < corners.size(); ++t) {
    if (corners_[t] == corners[t]) continue;
    corners_[t] = corners[t];
    left_[t] = {};
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
  stretched_.clear();
  moved_.clear();
  for (std::uint32_t t = 0; t < corners_.size(); ++t) {
    const auto& [a, b, c] = corners_[t];
    Left& left = left_[t];
    const double way = std::max({reach_[a.index], reach_[b.index], reach_[c.index]});
    if (way > 0) {
      const Vec3 moves[3] = {now[a.index] - last_[a.index], now[b.index] - last_[b.index],
                             now[c.index] - last_[c.index]};
      left.edges -=
          std::sqrt(std::max({squared_length(moves[0] - moves[1]), squared_length(moves[1] - moves[2]),
                              squared_length(moves[2] - moves[0])}));
      left.way -= way;
    }
    if (!(left.edges > 0)) stretched_.emplace_back(t);
    if (!(left.way > 0)) moved_.emplace_back(t);
  }
}

std::vector<Tangle> TangleWatch::look(const Film& film, std::span<const double> reaches) {
  const bool is_another = adopt(film);
  before_ = left_;
  spend(film, reaches);
  std::vector<Tangle> found;
  looked_at_ += static_cast<long>(stretched_.size() + moved_.size());
  // First all get what they may have at most, so that each pair can take from both; pairs of two that are
  // looked at are so once.
  due_.assign(corners_.size(), {});
  for (const Triangle t : stretched_) {
    left_[t.index].edges = longest_side(film.points(t));
    due_[t.index].edges = true;
  }
  for (const Triangle t : moved_) {
    left_[t.index].way = longest_way * longest_side(film.points(t));
    due_[t.index].way = true;
  }
  borders_.clear();
  for (const Triangle t : stretched_) look_around(film, t, found);
  std::sort(borders_.begin(), borders_.end());
  borders_.erase(std::unique(borders_.begin(), borders_.end()), borders_.end());
  for (const Edge e : borders_) {
    if (!is_out_of_order(film, e)) continue;
    Tangle part(film.ends(e).begin(), film.ends(e).end());
    film.for_each_side(e, [&](Side s) {
      part.push_back(film.opposite(s));
      left_[s.triangle().index].edges = 0;
    });
    found.push_back(std::move(part));
  }
  if (!moved_.empty() && !cells_.holds(film)) cells_.make(film);
  look_about(film, found);
  if (found.empty())
    last_.assign(film.positions().begin(), film.positions().end());
  else
    left_ = before_;
  if (!found.empty() && is_another) forget();  // nobody goes on from where it tangles
  return united(film, found);
}

void TangleWatch::note(const Film& film, Triangle t, Triangle other, std::vector<Tangle>& found) {
  found.push_back(corners_of_both(film, t, other));
  for (const Triangle each : {t, other}) left_[each.index] = {};
}

// The facets that have a corner in common with this one.
void TangleWatch::look_around(const Film& film, Triangle t, std::vector<Tangle>& found) {
  const auto was_compared = [&](Triangle other) { return due_[other.index].edges && other < t; };
  for (const Vertex v : film.corners(t)) {
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

void TangleWatch::compare_at_corner(const Film& film, Triangle t, Triangle other,
                                    std::vector<Tangle>& found) {
  const int shared = shared_corners(film.corners(t), film.corners(other));
  const std::array<double, 2> room =
      shared == 1 ? room_at_corner(film, t, other) : room_at_edge(film, t, other, part_of_altitude);
  double& own = left_[t.index].edges;
  double& others = left_[other.index].edges;
  own = std::min(own, room[0]);
  others = std::min(others, room[1]);
  if (std::min(room[0], room[1]) > 0) return;
  if (film::facets_cross(film, t, other)) note(film, t, other, found);
}

// In this call.
const Box& TangleWatch::box_of(const Film& film, Triangle t) {
  if (boxed_[t.index] != call_) {
    boxed_[t.index] = call_;
    boxes_[t.index] = widened_box(film.points(t));
  }
  return boxes_[t.index];
}

// The facets near those that moved that have no corner in common with them.
void TangleWatch::look_about(const Film& film, std::vector<Tangle>& found) {
  asked_.clear();
  boxes_.resize(film.triangle_rows());
  boxed_.resize(film.triangle_rows());
  ++call_;
  for (const Triangle t : moved_) asked_.push_back(box_of(film, t));
  cells_.for_each_near(asked_, [&](std::uint32_t i, Triangle other) {
    const Triangle t = moved_[i];
    const bool was_compared = due_[other.index].way && other < t;
    if (other != t && !was_compared && shared_corners(film.corners(t), film.corners(other)) == 0 &&
        box_of(film, other).meets(asked_[i]))
      compare_apart(film, t, other, found);
  });
}

void TangleWatch::compare_apart(const Film& film, Triangle t, Triangle other, std::vector<Tangle>& found) {
  const double gap = std::max(0.0, gap_at_least(film.points(t), film.points(other)));
  double& own = left_[t.index].way;
  double& others = left_[other.index].way;
  own = std::min(own, 0.5 * gap);
  others = std::min(others, 0.5 * gap);
  if ((gap <= 0 && film::facets_cross(film, t, other)) || have_met(film, t, other))
    note(film, t, other, found);
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
  std::vector<Vertex> row(film.vertex_rows());
  last_.clear();
  for (std::uint32_t v = 0; v < row.size(); ++v) {
    if (!film.alive(Vertex(v))) continue;
    row[v] = Vertex(static_cast<std::uint32_t>(last_.size()));
    last_.push_back(film.position(Vertex(v)));
  }
  std::vector<std::array<Vertex, 3>> kept;
  std::vector<Left> left;
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    if (!film.alive(Triangle(t))) continue;
    left.push_back(t < corners_.size() && corners_[t] == corners[t] ? left_[t] : Left{});
    kept.push_back({row[corners[t][0].index], row[corners[t][1].index], row[corners[t][2].index]});
  }
  left_ = std::move(left);
  corners_ = std::move(kept);
}

}  // namespace lamella::surgery
