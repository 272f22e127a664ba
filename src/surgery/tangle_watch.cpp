#include "surgery/tangle_watch.h"

#include <algorithm>
#include <cmath>

#include "surgery/sizing.h"

namespace lamella::surgery {

using film::EdgeEnd;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// Never to twice its size for a few rows more.
template <class T>
void grow(std::vector<T>& rows, std::size_t count) {
  if (rows.capacity() < count) rows.reserve(count + count / 8);
  rows.resize(count);
}

}  // namespace

// Facets that are not what they were are looked at, and everything if the film is another. Returns whether it
// is.
bool TangleWatch::adopt(const Film& film) {
  const std::vector<std::array<Vertex, 3>>& corners = film.connectivity().triangle_vertices;
  if (corners_.size() != corners.size() || last_.size() != film.vertex_rows()) {
    corners_ = corners;
    cells_.resize(corners.size());
    edges_.assign(corners.size(), unknown);
    listed_at_.assign(corners.size(), {});
    listed_for_.assign(corners.size(), 0);
    alone_.assign(corners.size(), 0);
    pairs_.clear();
    around_.assign(film.vertex_rows(), Around::no_sheet);
    axes_.resize(film.vertex_rows());
    last_.assign(film.positions().begin(), film.positions().end());
    return true;
  }
  if (connectivity_ == film.connectivity_revision()) return false;
  const std::vector<film::RegionPair>& regions = film.connectivity().triangle_regions;
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    if (cells_.is_relabelled(Triangle(t), regions[t])) listed_for_[t] = 0;
    if (corners_[t] == corners[t]) continue;
    corners_[t] = corners[t];
    edges_[t] = unknown;
    listed_for_[t] = 0;
  }
  return false;
}

// How far vertices have been since the last look.
void TangleWatch::measure_reach(const Film& film, std::span<const double> reaches) {
  const std::span<const Vec3> now = film.positions();
  reach_.assign(now.size(), 0);
  for (std::size_t v = 0; v < std::min(now.size(), last_.size()); ++v) reach_[v] = length(now[v] - last_[v]);
  if (reaches.size() == now.size()) {
    for (std::size_t v = 0; v < now.size(); ++v) reach_[v] = std::max(reach_[v], reaches[v]);
  }
}

// By how much the edges of a facet have changed since the last look.
double TangleWatch::edge_change(const Film& film, Triangle t) const {
  const std::span<const Vec3> now = film.positions();
  const auto& [a, b, c] = corners_[t.index];
  const Vec3 moves[3] = {now[a.index] - last_[a.index], now[b.index] - last_[b.index],
                         now[c.index] - last_[c.index]};
  return std::sqrt(std::max({squared_length(moves[0] - moves[1]), squared_length(moves[1] - moves[2]),
                             squared_length(moves[2] - moves[0])}));
}

// Whether a facet has moved, and it matters by how much its edges have changed: around flat vertices that
// does not.
bool TangleWatch::is_spent(Triangle t) const {
  const auto& corners = corners_[t.index];
  return way_[t.index] > 0 &&
         !std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return is_flat(v); });
}

// How far a facet has been, and what that takes of what its edges may change.
void TangleWatch::spend(const Film& film, Triangle t) {
  const auto& [a, b, c] = corners_[t.index];
  way_[t.index] = std::max({reach_[a.index], reach_[b.index], reach_[c.index]});
  if (is_spent(t)) edges_[t.index] -= edge_change(film, t);
}

// Whether a facet has gone so far from where it was listed that what is near it serves no longer, wherever it
// has been since the last call.
bool TangleWatch::is_far(Triangle t, double size) const {
  const double left = listed_for_[t.index] - way_[t.index] - listed_reach * size;
  if (!(left > 0)) return true;
  const auto& [a, b, c] = corners_[t.index];
  const Corners& at = listed_at_[t.index];
  return !(std::max({squared_length(last_[a.index] - at[0]), squared_length(last_[b.index] - at[1]),
                     squared_length(last_[c.index] - at[2])}) < left * left);
}

// Which facets are looked at, and which vertices may be flat no longer.
void TangleWatch::choose(const Film& film, std::span<const double> reaches) {
  const std::span<const double> sizes = film.columns(film::ElementKind::vertex).reals(size_column);
  measure_reach(film, reaches);
  stretched_.clear();
  moved_.clear();
  unsure_.clear();
  way_.resize(corners_.size());
  due_.resize(corners_.size());
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const Triangle t(i);
    const auto& [a, b, c] = corners_[i];
    const double size = sizes.empty() ? 0 : std::max({sizes[a.index], sizes[b.index], sizes[c.index]});
    bool has_turned = false;
    spend(film, t);
    if (way_[i] > 0) {
      const Vec3& p = film.position(a);
      const Vec3 normal = cross(film.position(b) - p, film.position(c) - p);
      has_turned = cells_.has_turned(t, normal, film.regions(t));
      for (const Vertex v : corners_[i]) {
        if (has_turned_over(v, normal)) unsure_.push_back(v);
      }
    }
    due_[i] = {!(edges_[i] > 0), has_turned || is_far(t, size)};
    if (due_[i].edges) stretched_.push_back(t);
    if (due_[i].way) moved_.push_back(t);
  }
}

std::vector<Tangle> TangleWatch::look(const Film& film, std::span<const double> reaches) {
  const bool is_another = adopt(film);
  choose(film, reaches);
  std::vector<Tangle> found;
  looked_at_ += static_cast<long>(stretched_.size());
  look_around(film, found);
  look_at_borders(film, found);
  looked_at_ += static_cast<long>(moved_.size());
  look_at_pairs(film, found);
  list_anew(film, found);
  positions_ = film.position_revision();
  connectivity_ = film.connectivity_revision();
  if (found.empty())
    last_.assign(film.positions().begin(), film.positions().end());
  else if (is_another)
    forget();
  else
    go_back(film);
  return united(film, found);
}

// Nobody goes on from where a film tangles: what was spent on the way there is given back, and what was found
// there is not so.
void TangleWatch::go_back(const Film& film) {
  for (std::uint32_t t = 0; t < corners_.size(); ++t) {
    if (due_[t].edges)
      edges_[t] = unknown;
    else if (is_spent(Triangle(t)))
      edges_[t] += edge_change(film, Triangle(t));
  }
  for (const Vertex v : unsure_) {
    film.for_each_end(v, [&](EdgeEnd end) {
      film.for_each_side(end.edge(), [&](Side s) { edges_[s.triangle().index] = unknown; });
    });
  }
  for (FacetPair& pair : pairs_) pair.gap += way_[pair.a.index] + way_[pair.b.index];
  for (const std::size_t n : measured_) pairs_[n].gap = 0;
}

// Facets that surgery has moved, and left in place. What of them has turned is as unknown as what it made.
void TangleWatch::spend_on_surgery(const Film& film) {
  const auto& corners = film.connectivity().triangle_vertices;
  measure_reach(film, {});
  way_.resize(corners_.size());
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const Triangle t(i);
    spend(film, t);
    if (!(way_[i] > 0) || !film.alive(t) || corners_[i] != corners[i]) continue;
    const auto& [a, b, c] = corners_[i];
    const Vec3& p = film.position(a);
    const Vec3 normal = cross(film.position(b) - p, film.position(c) - p);
    if (cells_.has_turned(t, normal, film.regions(t))) listed_for_[i] = 0;
    for (const Vertex v : corners_[i]) {
      if (has_turned_over(v, normal)) edges_[i] = unknown;
    }
  }
}

// New rows are those of what is alive, in order. Facets that were made since, or have other corners now, have
// nothing left. What surgery has moved has spent its way, and is followed no further.
void TangleWatch::before_compaction(const Film& film) {
  const auto& corners = film.connectivity().triangle_vertices;
  spend_on_surgery(film);
  for (FacetPair& pair : pairs_) pair.gap -= way_[pair.a.index] + way_[pair.b.index];
  // Rows move down if they move, so that each array is its own copy.
  grow(around_, film.vertex_rows());
  grow(axes_, film.vertex_rows());
  std::vector<Vertex> row(film.vertex_rows());
  last_.clear();
  for (std::uint32_t v = 0; v < row.size(); ++v) {
    if (!film.alive(Vertex(v))) continue;
    const std::size_t to = last_.size();
    row[v] = Vertex(static_cast<std::uint32_t>(to));
    last_.push_back(film.position(Vertex(v)));
    around_[to] = around_[v];
    axes_[to] = axes_[v];
  }
  around_.resize(last_.size());
  axes_.resize(last_.size());
  const std::size_t before = corners_.size();
  grow(corners_, corners.size());
  grow(edges_, corners.size());
  grow(listed_at_, corners.size());
  grow(listed_for_, corners.size());
  grow(alone_, corners.size());
  std::vector<Triangle> facet(corners.size());  // of those that are what they were
  std::uint32_t to = 0;
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    if (!film.alive(Triangle(t))) continue;
    const bool same = t < before && corners_[t] == corners[t];
    if (same) facet[t] = Triangle(to);
    edges_[to] = same ? edges_[t] : unknown;
    listed_at_[to] = same ? listed_at_[t] : Corners{};
    listed_for_[to] = same ? listed_for_[t] : 0;
    alone_[to] = same ? alone_[t] : std::uint8_t{0};
    corners_[to++] = {row[corners[t][0].index], row[corners[t][1].index], row[corners[t][2].index]};
  }
  corners_.resize(to);
  edges_.resize(to);
  listed_at_.resize(to);
  listed_for_.resize(to);
  alone_.resize(to);
  std::erase_if(pairs_, [&](FacetPair& pair) {
    pair = {facet[pair.a.index], facet[pair.b.index], pair.gap};
    return !pair.a.valid() || !pair.b.valid();
  });
  cells_.rename(facet, to);
  connectivity_ = 0;  // of no film: what is known of its facets is compared with the next
}

}  // namespace lamella::surgery
