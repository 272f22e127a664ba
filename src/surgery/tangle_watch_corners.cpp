#include <algorithm>
#include <cmath>

#include "film/intersections.h"
#include "surgery/tangle_watch.h"
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

// Films at an edge cannot change places before the edges of a facet have changed by this part of its altitude
// times the distance of unit vectors across the edge.
constexpr double part_of_altitude = 0.2;
// A sheet is flat around a vertex where the normals of its facets turn from their mean by less than what this
// is the cosine of (37 degrees).
constexpr double flat_cosine = 0.8;
constexpr std::size_t most_in_fan = 32;
constexpr std::uint32_t most_stamps = 1U << 31U;  // before vertices are marked from the beginning again

int shared_corners(const std::array<Vertex, 3>& a, const std::array<Vertex, 3>& b) {
  int count = 0;
  for (const Vertex v : a) count += v == b[0] || v == b[1] || v == b[2] ? 1 : 0;
  return count;
}

}  // namespace

// Facets whose edges have changed, and those that have a corner in common with them. First all get what they
// may have at most, so that each pair can take from it.
void TangleWatch::look_around(const Film& film, std::vector<Tangle>& found) {
  look_at_vertices(film);
  for (const Triangle t : stretched_) edges_[t.index] = longest_side(film.points(t));
  borders_.clear();
  for (const Triangle t : stretched_) {
    // Pairs of two that are looked at are so once.
    const auto was_compared = [&](Triangle other) { return due_[other.index].edges && other < t; };
    for (const Vertex v : film.corners(t)) {
      if (is_flat(v)) continue;
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

// Those that may be flat no longer, or may be now, each once.
void TangleWatch::look_at_vertices(const Film& film) {
  if (stamps_ > most_stamps) stamp_.clear();
  if (stamp_.empty()) stamps_ = 0;
  stamp_.resize(std::max<std::size_t>(stamp_.size(), film.vertex_rows()));
  stamps_ += 2;
  const auto look_once = [&](Vertex v) {
    if (stamp_[v.index] != stamps_) look_at_vertex(film, v);
    stamp_[v.index] = stamps_;
  };
  for (const Vertex v : unsure_) look_once(v);
  for (std::size_t i = 0; i < stretched_.size(); ++i) {
    const Triangle t = stretched_[i];
    for (const Vertex v : film.corners(t)) {
      if (around_[v.index] == Around::rough || edges_[t.index] == unknown) look_once(v);
    }
  }
}

// Facets around a vertex that is no longer flat are compared with one another, and listed with all that is
// near them.
void TangleWatch::look_at_vertex(const Film& film, Vertex v) {
  const bool was_flat = is_flat(v);
  around_[v.index] = look_around(film, v);
  if (!was_flat || is_flat(v)) return;
  film.for_each_end(v, [&](EdgeEnd end) {
    film.for_each_side(end.edge(), [&](Side s) {
      Due& due = due_[s.triangle().index];
      if (!due.way) moved_.push_back(s.triangle());
      if (!due.edges) stretched_.push_back(s.triangle());
      due = {true, true};
    });
  });
}

// Whether the facets at a vertex go once around it in one sheet, their normals near a mean. Then a plane
// shows them side by side, and does so until one of the normals has turned by a right angle from that mean.
TangleWatch::Around TangleWatch::look_around(const Film& film, Vertex v) {
  const EdgeEnd first = film.first_end(v);
  if (film.periodic() || !first.valid() || !film.first_side(first.edge()).valid()) return Around::no_sheet;
  ring_.clear();
  Side s = film.first_side(first.edge());
  const bool leads_out = film.tail(film.edge_of(s)) == v;
  do {
    const film::SignedEdge edge = film.edge_of(s);
    // Their normals are to show to one side.
    if ((film.tail(edge) == v) != leads_out) return Around::no_sheet;
    ring_.push_back(film.position(leads_out ? film.head(edge) : film.tail(edge)) - film.position(v));
    const Side other(s.triangle(),
                     leads_out ? film::previous_corner(s.corner()) : film::next_corner(s.corner()));
    s = film.next_around(other);
    if (s == other || film.next_around(s) != other || ring_.size() > most_in_fan) return Around::no_sheet;
  } while (film.edge_of(s).edge() != first.edge());
  std::size_t ends = 0;
  film.for_each_end(v, [&](EdgeEnd) { ++ends; });
  if (ends != ring_.size()) return Around::no_sheet;
  Vec3 axis;
  const auto after = [&](std::size_t i) -> const Vec3& { return ring_[i + 1 < ends ? i + 1 : 0]; };
  for (std::size_t i = 0; i < ends; ++i) axis += unit(cross(ring_[i], after(i)));
  axis = unit(axis);
  const Vec3 upward = cross(axis, ring_[0] + 0.5 * after(0));
  int turns = 0;
  for (std::size_t i = 0; i < ends; ++i) {
    const Vec3 normal = cross(ring_[i], after(i));
    if (!(dot(normal, axis) > flat_cosine * length(normal))) return Around::rough;
    if (dot(upward, ring_[i]) < 0 && dot(upward, after(i)) >= 0) ++turns;
  }
  if (!leads_out) axis = -axis;
  axes_[v.index] = {static_cast<float>(axis.x), static_cast<float>(axis.y), static_cast<float>(axis.z)};
  return turns == 1 ? Around::flat : Around::rough;
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
  if (film::facets_cross(film, t, other)) found.push_back(corners_of(film, t, other));
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

}  // namespace lamella::surgery
