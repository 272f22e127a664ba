#include "surgery/remesh.h"

#include <algorithm>
#include <cmath>

#include "film/crossing_grid.h"
#include "scene/constraint_sets.h"
#include "surgery/contract.h"
#include "surgery/equiangulate.h"
#include "surgery/feature.h"
#include "surgery/flip.h"
#include "surgery/patch.h"
#include "surgery/shrink.h"
#include "surgery/sizing.h"
#include "surgery/smooth.h"
#include "surgery/split_edge.h"
#include "surgery/wedge.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

// Edges of a facet that shrinks to a line may be this long and still collapse.
constexpr double needle = 0.9;
// A cluster is stuck when its edges are shorter than this; in units of the size.
constexpr double coming_together = 0.75;
constexpr double border_coming_together = 0.35;
constexpr int flip_passes = 3;
// Where films at a border are nearer than this (radians), vertices stay on their facets.
constexpr double tight_wedge = 40 * M_PI / 180;
constexpr double needle_altitude = 0.1;  // in sizes, of a facet whose corner has come near a line
constexpr double rim_passed = 0.2;       // the altitude, in sizes, of facets that a free rim takes back
constexpr double room_to_grow = 0.9;     // of the longest edge, for one that a collapse makes

double edge_length(const Film& film, Edge e) {
  return length(film.vector(SignedEdge(e, false)));
}

double relative_length(const Film& film, Edge e) {
  return edge_length(film, e) / size_of(film, e);
}

std::vector<Triangle> facets_around(const Film& film, Edge e) {
  std::vector<Triangle> facets;
  film.for_each_side(e, [&](Side s) { facets.push_back(s.triangle()); });
  return facets;
}

double relative_altitude(const std::array<Vec3, 3>& p) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, squared_length(p[(k + 1) % 3] - p[k]));
  return longest > 0 ? length(cross(p[1] - p[0], p[2] - p[0])) / longest : 0;
}

class Remesher {
 public:
  Remesher(Scene& scene, const RemeshOptions& options)
      : scene_(scene), film_(scene.film), options_(options) {}

  RemeshReport run() {
    keep_sizes(film_);
    for (int round = 0; round < options_.rounds; ++round) {
      const long before = report_.operations();
      begin_round();
      divide_long();
      collapse_short();
      mend_slivers();
      flip();
      if (report_.operations() == before) break;
      even_out();
    }
    return std::move(report_);
  }

 private:
  struct Ranked {
    double rank = 0;
    Edge edge;
  };
  template <class Wanted>
  std::vector<Ranked> edges_where(Wanted wanted) const;
  void begin_round();
  bool is_open(Vertex v) const { return round_ == 1 || touched_in_[v.index] + 1 >= round_; }
  bool is_open(Edge e) const {
    const auto& [tail, head] = film_.ends(e);
    return is_open(tail) || is_open(head);
  }
  void note_change(Vertex v) {
    if (touched_in_.size() < film_.vertex_rows()) {
      touched_in_.resize(film_.vertex_rows(), round_);
      flipped_in_.resize(film_.vertex_rows());
    }
    touched_in_[v.index] = round_;
  }
  void touch(Vertex v) {
    report_.touched.push_back(v);
    note_change(v);
  }
  void divide_long();
  void collapse_short();
  bool collapse(Edge e);
  void mend_slivers();
  void flip();
  bool flip_edge(Edge e, double slack);
  bool retract(Triangle t);
  void mend_needle(Triangle t, const std::array<Edge, 3>& sides);
  void even_out();
  Vertex divide(Edge e);
  bool may_move(Vertex v, const Vec3& to);
  // Made when it is first asked for: most passes have nothing to do.
  film::CrossingGrid& grid() {
    if (!grid_) grid_.emplace(film_);
    return *grid_;
  }

  Scene& scene_;
  Film& film_;
  RemeshOptions options_;
  RemeshReport report_;
  std::optional<film::CrossingGrid> grid_;
  // After the first round only what has changed since the one before, and what is next to it, is looked at:
  // the round in which each vertex was last touched, and the pass of flips.
  int round_ = 0;
  int flip_pass_ = 0;
  std::vector<int> touched_in_;
  std::vector<int> flipped_in_;
};

// What stood in the way in the round before is looked at again where something has changed around it.
void Remesher::begin_round() {
  ++round_;
  touched_in_.resize(film_.vertex_rows());
  flipped_in_.resize(film_.vertex_rows());
  if (round_ == 1) return;
  std::vector<Vertex> next_to;
  for (std::uint32_t i = 0; i < film_.edge_rows(); ++i) {
    if (!film_.alive(Edge(i))) continue;
    const auto& [tail, head] = film_.ends(Edge(i));
    if (is_open(tail) != is_open(head)) next_to.push_back(is_open(tail) ? head : tail);
  }
  for (const Vertex v : next_to) note_change(v);
  std::erase_if(report_.stuck, [&](const std::vector<Vertex>& cluster) {
    return std::any_of(cluster.begin(), cluster.end(),
                       [&](Vertex v) { return !film_.alive(v) || is_open(v); });
  });
}

template <class Wanted>
std::vector<Remesher::Ranked> Remesher::edges_where(Wanted wanted) const {
  std::vector<Ranked> list;
  const auto sizes = film_.columns(film::ElementKind::vertex).reals(size_column);
  for (std::uint32_t i = 0; i < film_.edge_rows(); ++i) {
    if (!film_.alive(Edge(i)) || !is_open(Edge(i))) continue;
    const auto& [tail, head] = film_.ends(Edge(i));
    const double size = 0.5 * (sizes[tail.index] + sizes[head.index]);
    const double relative = size > 0 ? edge_length(film_, Edge(i)) / size : relative_length(film_, Edge(i));
    if (wanted(relative)) list.push_back({relative, Edge(i)});
  }
  return list;
}

// Off the chord, where the film curves, unless that leads through another film.
Vertex Remesher::divide(Edge e) {
  const std::vector<Triangle> around = facets_around(film_, e);
  const Vec3 place = smooth_middle(scene_, e);
  const Vertex made(film_.vertex_rows());
  std::vector<film::FacetShape> shapes;
  for (const Triangle t : around) {
    const film::FacetShape whole = film::shape_of(film_, t);
    for (const Vertex end : film_.ends(e)) {
      film::FacetShape half = whole;
      for (std::size_t k = 0; k < 3; ++k) {
        if (half.corners[k] != end) continue;
        half.corners[k] = made;
        half.points[k] = place;
      }
      shapes.push_back(half);
    }
  }
  const bool straight = has_narrow_wedge(film_, around, tight_wedge) || grid().crosses(shapes, around);
  const Vertex v = straight ? split_edge(film_, e) : split_edge(film_, e, place);
  grid().add_around(v);
  return v;
}

void Remesher::divide_long() {
  std::vector<Ranked> list = edges_where([&](double relative) { return relative > options_.longest; });
  std::sort(list.begin(), list.end(), [](const Ranked& a, const Ranked& b) { return a.rank > b.rank; });
  const std::uint32_t first_made = film_.vertex_rows();
  for (const Ranked& each : list) {
    const Edge e = each.edge;
    if (is_fixed(film_, film::ElementKind::edge, e.index) && !film_.first_side(e).valid()) continue;
    const Vertex made = divide(e);
    ++report_.splits;
    touch(made);
    film_.for_each_end(made, [&](EdgeEnd end) { touch(film_.head(end.outward())); });
  }
  const bool curves = !scene_.boundaries.empty() || !scene_.level_sets.empty();
  if (curves && film_.vertex_rows() > first_made) scene::settle_vertices(scene_, first_made);
}

bool Remesher::collapse(Edge e) {
  const double size = size_of(film_, e);
  const Shrink shrink = shrink_edge(scene_, e, room_to_grow * options_.longest * size, &grid());
  if (shrink.outcome == ShrinkOutcome::topology) {
    const double most = shrink.cluster.size() == 2 ? border_coming_together : coming_together;
    const Vec3 at = film_.position(shrink.cluster[0]);
    const bool near = std::all_of(shrink.cluster.begin(), shrink.cluster.end(),
                                  [&](Vertex v) { return length(film_.position(v) - at) < most * size; });
    if (near) report_.stuck.push_back(shrink.cluster);
  }
  if (shrink.outcome != ShrinkOutcome::done) return false;
  ++report_.collapses;
  touch(shrink.kept);
  film_.for_each_end(shrink.kept, [&](EdgeEnd end) { touch(film_.head(end.outward())); });
  return true;
}

void Remesher::collapse_short() {
  std::vector<Ranked> list = edges_where([&](double relative) { return relative < options_.shortest; });
  std::sort(list.begin(), list.end(), [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
  for (const Ranked& each : list) {
    if (film_.alive(each.edge) && relative_length(film_, each.edge) < options_.shortest) collapse(each.edge);
  }
}

// A facet that its film's free rim has nearly passed by: two of its sides are rims, or its longest, and it is
// low.
bool Remesher::retract(Triangle t) {
  const auto& corners = film_.corners(t);
  const auto& sides = film_.edges(t);
  // Neither a wire nor where a film stands on a constraint: those hold both ends.
  const auto is_rim = [&](SignedEdge e) {
    const Side first = film_.first_side(e.edge());
    if (film_.next_around(first) != first) return false;
    const auto& ends = film_.ends(e.edge());
    return (is_free(scene_, ends[0]) || is_free(scene_, ends[1])) &&
           !is_fixed(film_, film::ElementKind::edge, e.edge().index) &&
           scene::boundary_of(scene_, film::ElementKind::edge, e.edge().index) == 0;
  };
  const auto rims = std::count_if(sides.begin(), sides.end(), is_rim);
  if (rims == 0) return false;
  const auto points = film_.points(t);
  const double twice = length(cross(points[1] - points[0], points[2] - points[0]));
  const SignedEdge longest = *std::max_element(sides.begin(), sides.end(), [&](SignedEdge a, SignedEdge b) {
    return edge_length(film_, a.edge()) < edge_length(film_, b.edge());
  });
  const double low = twice / edge_length(film_, longest.edge()) / size_of(film_, corners[0]);
  const bool passed = rims >= 2 ? low < rim_passed : low < needle_altitude && is_rim(longest);
  if (!passed) return false;
  const std::array<Vertex, 3> around = corners;
  replace(film_, {{t}, {}});
  for (const Vertex v : around) touch(v);
  ++report_.collapses;
  return true;
}

// A flat triangle is flipped over its longest side, or its shortest collapses.
void Remesher::mend_slivers() {
  const std::uint32_t rows = film_.triangle_rows();
  for (std::uint32_t i = 0; i < rows; ++i) {
    const Triangle t(i);
    if (!film_.alive(t)) continue;
    const auto& corners = film_.corners(t);
    const bool open = std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return is_open(v); });
    if (!open || retract(t)) continue;
    if (relative_altitude(film_.points(t)) > options_.sliver) continue;
    std::array<Edge, 3> sides;
    for (std::size_t k = 0; k < 3; ++k) sides[k] = film_.edges(t)[k].edge();
    std::sort(sides.begin(), sides.end(),
              [&](Edge a, Edge b) { return edge_length(film_, a) < edge_length(film_, b); });
    if (flip_edge(sides[2], 0)) continue;
    if (relative_length(film_, sides[0]) < needle && collapse(sides[0])) continue;
    mend_needle(t, sides);
  }
}

// A corner that has come near a line on the opposite side: the line gets a vertex there, and the two collapse
// or change the film's topology.
void Remesher::mend_needle(Triangle t, const std::array<Edge, 3>& sides) {
  const Edge line = sides[2];
  if (!is_line(scene_, line) || !film_.first_side(line).valid() ||
      is_fixed(film_, film::ElementKind::edge, line.index))
    return;
  const auto [tail, head] = film_.ends(line);
  Vertex apex;
  for (const Vertex v : film_.corners(t)) {
    if (v != tail && v != head) apex = v;
  }
  const Vec3 along = film_.vector(SignedEdge(line, false));
  const double part = dot(film_.position(apex) - film_.position(tail), along) / squared_length(along);
  const double low = length(film_.position(tail) + part * along - film_.position(apex));
  if (low > needle_altitude * size_of(film_, line) || part < 0.1 || part > 0.9) return;
  const Vertex foot = split_edge(film_, line, film_.position(tail) + part * along);
  grid().add_around(foot);
  ++report_.splits;
  touch(foot);
  film_.for_each_end(foot, [&](EdgeEnd end) { touch(film_.head(end.outward())); });
  const SignedEdge between = film_.find_edge(foot, apex);
  if (between.valid()) collapse(between.edge());
}

// True if the angles opposite to the edge sum to more than a half turn plus the slack.
bool exceeds(const Film& film, const Diagonal& d, double slack) {
  const auto angle = [&](Vertex at) {
    return angle_between(film.position(d.p) - film.position(at), film.position(d.q) - film.position(at));
  };
  return angle(d.r) + angle(d.w) > M_PI + slack;
}

// Told without angles, for all edges: that those opposite to an edge do not exceed a half turn.
bool may_exceed(const Film& film, Edge e) {
  const Side first = film.first_side(e);
  const auto [p, q] = film.ends(e);
  const auto parts = [&](Side s) {
    const Vec3 at = film.position(film.opposite(s));
    const Vec3 to_p = film.position(p) - at;
    const Vec3 to_q = film.position(q) - at;
    return std::pair(dot(to_p, to_q), cross(to_p, to_q));
  };
  const auto [cos_first, sin_first] = parts(first);
  const auto [cos_second, sin_second] = parts(film.next_around(first));
  if (cos_first > 0 && cos_second > 0) return false;
  return length(sin_first) * cos_second + cos_first * length(sin_second) <= 0;
}

bool Remesher::flip_edge(Edge e, double slack) {
  if (!film_.first_side(e).valid() || !may_exceed(film_, e)) return false;
  const std::optional<Diagonal> diagonal = flippable(film_, e);
  if (!diagonal || is_line(scene_, e) || !exceeds(film_, *diagonal, slack + 1e-9)) return false;
  if (!flip_is_flat(film_, *diagonal)) return false;
  if (length(film_.position(diagonal->r) - film_.position(diagonal->w)) >
      options_.longest * size_of(film_, e))
    return false;
  if (has_narrow_wedge(film_, facets_around(film_, e), tight_wedge)) return false;
  const Vec3 p = film_.position(diagonal->p);
  const Vec3 q = film_.position(diagonal->q);
  const Vec3 r = film_.position(diagonal->r);
  const Vec3 w = film_.position(diagonal->w);
  const std::array<film::FacetShape, 2> made{{{{diagonal->p, diagonal->r, diagonal->w}, {p, r, w}},
                                              {{diagonal->q, diagonal->w, diagonal->r}, {q, w, r}}}};
  if (grid().crosses(made, facets_around(film_, e))) return false;
  surgery::flip(film_, *diagonal);
  grid().add_around(diagonal->r);
  ++report_.flips;
  for (const Vertex v : {diagonal->p, diagonal->q, diagonal->r, diagonal->w}) {
    touch(v);
    flipped_in_[v.index] = flip_pass_;
  }
  return true;
}

void Remesher::flip() {
  for (int pass = 0; pass < flip_passes; ++pass) {
    const long before = report_.flips;
    ++flip_pass_;
    const auto is_due = [&](Edge e) {
      const auto& [tail, head] = film_.ends(e);
      return std::max(flipped_in_[tail.index], flipped_in_[head.index]) + 1 >= flip_pass_;
    };
    for (std::uint32_t i = 0; i < film_.edge_rows(); ++i) {
      const Edge e(i);
      if (!film_.alive(e) || !film_.first_side(e).valid()) continue;
      if (pass == 0 ? is_open(e) : is_due(e)) flip_edge(e, options_.flip_slack);
    }
    if (report_.flips == before) return;
  }
}

void Remesher::even_out() {
  std::vector<Vertex>& touched = report_.touched;
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::vector<std::pair<Vertex, Vec3>> moves;
  for (const Vertex v : touched) {
    if (!film_.alive(v) || rank_of(scene_, v) != Rank::sheet) continue;
    if (!scene::constraints_of(scene_, film::ElementKind::vertex, v.index).empty()) continue;
    if (has_narrow_wedge(film_, facets_at(film_, std::span(&v, 1)), tight_wedge)) continue;
    const Vec3 move = averaging_move(film_, v, Averaging::keep_volume);
    if (length(move) > options_.least_move * size_of(film_, v)) moves.emplace_back(v, move);
  }
  for (const auto& [v, move] : moves) {
    if (!may_move(v, film_.position(v) + move)) continue;
    film_.move(v, film_.position(v) + move);
    grid().add_around(v);
    note_change(v);
    ++report_.moved;
  }
}

bool Remesher::may_move(Vertex v, const Vec3& to) {
  const std::vector<Triangle> star = facets_at(film_, std::span(&v, 1));
  std::vector<film::FacetShape> shapes;
  for (const Triangle t : star) {
    film::FacetShape shape = film::shape_of(film_, t);
    for (std::size_t k = 0; k < 3; ++k) {
      if (shape.corners[k] == v) shape.points[k] = to;
    }
    shapes.push_back(shape);
  }
  return !grid().crosses(shapes, star);
}

}  // namespace

bool needs_remesh(const Film& film, std::span<const Vec3> positions, const RemeshOptions& options) {
  if (film.periodic()) return false;
  if (!has_sizes(film)) return true;
  const auto sizes = film.columns(film::ElementKind::vertex).reals(size_column);
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const auto& [tail, head] = film.ends(Edge(i));
    const double square = squared_length(positions[head.index] - positions[tail.index]);
    const double size = 0.5 * (sizes[tail.index] + sizes[head.index]);
    if (square > options.longest * options.longest * size * size ||
        square < options.shortest * options.shortest * size * size)
      return true;
  }
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const auto& c = film.corners(Triangle(i));
    if (relative_altitude({positions[c[0].index], positions[c[1].index], positions[c[2].index]}) <
        options.sliver)
      return true;
  }
  return false;
}

RemeshReport remesh(Scene& scene, const RemeshOptions& options) {
  return scene.film.periodic() ? RemeshReport{} : Remesher(scene, options).run();
}

}  // namespace lamella::surgery
