#include "surgery/shrink.h"

#include <algorithm>
#include <cmath>

#include "surgery/collapse_edge.h"
#include "surgery/feature.h"
#include "surgery/patch.h"
#include "surgery/wedge.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Region;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

constexpr double least_cosine = 0.5;    // of the turn of a facet
constexpr double good_altitude = 0.15;  // in units of the longest side
constexpr double most_shift = 0.25;     // for the volumes, in units of the edge
constexpr int volume_sweeps = 8;
constexpr double least_wedge = 8 * M_PI / 180;  // that may come about between films at a border

struct Shape {
  Vec3 normal;  // twice the area long
  double altitude = 0;
  double longest = 0;
};

Shape shape_of(const std::array<Vec3, 3>& p) {
  Shape shape;
  shape.normal = cross(p[1] - p[0], p[2] - p[0]);
  for (std::size_t k = 0; k < 3; ++k) shape.longest = std::max(shape.longest, length(p[(k + 1) % 3] - p[k]));
  shape.altitude = shape.longest > 0 ? length(shape.normal) / shape.longest : 0;
  return shape;
}

class Shrinker {
 public:
  Shrinker(Scene& scene, Edge e, double longest, film::CrossingGrid* grid)
      : scene_(scene),
        film_(scene.film),
        edge_(e),
        longest_(longest),
        grid_(grid),
        tail_(film_.ends(e)[0]),
        head_(film_.ends(e)[1]) {}

  Shrink run() {
    Shrink result;
    if (!rank(result) || !linked_well(result)) return result;
    place();
    result.outcome = ShrinkOutcome::geometry;
    if (!keeps_shape() || !keeps_order() || !keeps_clear()) return result;
    result.outcome = ShrinkOutcome::held;
    const Vec3 velocity = common_velocity();
    if (collapse_edge(scene_, edge_) != Collapse::done) return result;
    result.outcome = ShrinkOutcome::done;
    result.kept = film_.alive(tail_) ? tail_ : head_;
    set_velocity(result.kept, velocity);
    if (is_free_to_place_) film_.move(result.kept, target_);
    if (grid_ != nullptr) grid_->add_around(result.kept);
    return result;
  }

 private:
  bool rank(Shrink& result);
  bool linked_well(Shrink& result);
  void place();
  void keep_volumes();
  bool keeps_shape() const;
  bool keeps_order() const;
  bool keeps_clear() const;
  bool stays_in_order(Edge e) const;
  Vec3 place_of(Vertex v) const { return v == tail_ || v == head_ ? target_ : film_.position(v); }
  Vec3 common_velocity() const;
  void set_velocity(Vertex v, const Vec3& velocity);
  std::array<Vec3, 3> moved(Triangle t) const;
  bool is_flap(Triangle t) const { return std::find(flaps_.begin(), flaps_.end(), t) != flaps_.end(); }

  Scene& scene_;
  Film& film_;
  Edge edge_;
  double longest_;
  film::CrossingGrid* grid_;
  Vertex tail_;
  Vertex head_;
  Rank tail_rank_ = Rank::sheet;
  Rank head_rank_ = Rank::sheet;
  bool is_free_to_place_ = true;
  Vec3 target_;
  std::vector<Triangle> flaps_;
  std::vector<Triangle> around_;
};

bool may_vanish(Rank rank, bool along_line) {
  return rank == Rank::sheet ? !along_line : rank < Rank::corner && along_line;
}

bool Shrinker::rank(Shrink& result) {
  tail_rank_ = rank_of(scene_, tail_);
  head_rank_ = rank_of(scene_, head_);
  const Rank lower = std::min(tail_rank_, head_rank_);
  if (may_vanish(lower, is_line(scene_, edge_))) return true;
  // Two borders that a film no wider than this edge keeps apart, or the ends of one that is short.
  const bool between_borders = lower >= Rank::border && lower != Rank::wire && !is_line(scene_, edge_);
  if (between_borders || (lower == Rank::corner && film_.valence(edge_) > 2)) {
    result.outcome = ShrinkOutcome::topology;
    result.cluster = {tail_, head_};
  }
  return false;
}

bool Shrinker::linked_well(Shrink& result) {
  std::vector<Vertex> apexes;
  const auto refuse = [&](Vertex w) {
    result.outcome = ShrinkOutcome::topology;
    result.cluster = {tail_, head_, w};
    return false;
  };
  Vertex bad;
  film_.for_each_side(edge_, [&](Side s) {
    const Vertex w = film_.opposite(s);
    if (std::find(apexes.begin(), apexes.end(), w) != apexes.end()) bad = w;
    apexes.push_back(w);
    flaps_.push_back(s.triangle());
    int lines = 0;
    for (const film::SignedEdge e : film_.edges(s.triangle()))
      lines += e.edge() != edge_ && is_line(scene_, e.edge()) ? 1 : 0;
    if (lines > 1) bad = w;
  });
  if (bad.valid()) return refuse(bad);
  std::vector<Vertex> around;
  film_.for_each_end(tail_, [&](EdgeEnd end) {
    const Vertex w = film_.head(end.outward());
    if (std::find(apexes.begin(), apexes.end(), w) == apexes.end()) around.push_back(w);
  });
  film_.for_each_end(head_, [&](EdgeEnd end) {
    const Vertex w = film_.head(end.outward());
    if (std::find(around.begin(), around.end(), w) != around.end()) bad = w;
  });
  if (bad.valid()) return refuse(bad);
  around_ = facets_at(film_, std::array{tail_, head_});
  return true;
}

void Shrinker::place() {
  if (tail_rank_ != head_rank_) {
    target_ = film_.position(tail_rank_ > head_rank_ ? tail_ : head_);
    return;
  }
  // On what it is held to, a vertex goes where collapse_edge puts it.
  is_free_to_place_ = tail_rank_ != Rank::wire;
  target_ = is_free_to_place_ ? smooth_middle(scene_, edge_)
                              : 0.5 * (film_.position(tail_) + film_.position(head_));
  if (is_free_to_place_) keep_volumes();
}

// The volume between the old facets and the new ones is linear in where the vertex goes. Each sweep takes the
// shortest way to make it zero for one region after the other; in an open film sides take their place.
void Shrinker::keep_volumes() {
  const Vec3 origin = film_.position(tail_);
  std::vector<Region> regions;
  for (const Triangle t : around_) {
    const film::RegionPair pair = film_.regions(t);
    if (pair.front == pair.behind && tail_rank_ != Rank::sheet) return;
    regions.push_back(pair.front);
    regions.push_back(pair.behind);
  }
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  const bool open = regions.size() == 1;
  if (open) regions = {film::outside_region};
  Vec3 toward;
  for (const Triangle t : around_) {
    const Vec3 n = shape_of(film_.points(t)).normal;
    toward += dot(n, toward) < 0 ? -n : n;
  }
  const auto sign = [&](Triangle t, Region r) {
    if (open) return dot(shape_of(film_.points(t)).normal, toward) < 0 ? -1.0 : 1.0;
    const film::RegionPair pair = film_.regions(t);
    return (pair.behind == r ? 1.0 : 0.0) - (pair.front == r ? 1.0 : 0.0);
  };
  Vec3 x = target_ - origin;
  for (int sweep = 0; sweep < volume_sweeps; ++sweep) {
    for (const Region r : regions) {
      Vec3 slope;
      double change = 0;
      for (const Triangle t : around_) {
        const double factor = sign(t, r);
        auto p = film_.points(t);
        for (Vec3& q : p) q -= origin;
        change += factor * dot(p[0], cross(p[1], p[2]));
        if (is_flap(t)) continue;
        const auto& c = film_.corners(t);
        for (std::size_t k = 0; k < 3; ++k) {
          if (c[k] == tail_ || c[k] == head_) slope += factor * cross(p[(k + 1) % 3], p[(k + 2) % 3]);
        }
      }
      const double square = squared_length(slope);
      if (square > 0) x += ((change - dot(slope, x)) / square) * slope;
    }
  }
  const Vec3 shift = x - (target_ - origin);
  if (length(shift) < most_shift * length(film_.vector(film::SignedEdge(edge_, false)))) target_ = origin + x;
}

// Whether the films around an edge would still turn once around it. Where a facet vanishes, the one beyond
// its third side takes its place.
bool Shrinker::stays_in_order(Edge e) const {
  const auto [tail, head] = film_.ends(e);
  const Vec3 axis = place_of(head) - place_of(tail);
  if (squared_length(axis) <= 0) return false;
  std::vector<Vec3> directions;
  film_.for_each_side(e, [&](Side s) {
    Vertex apex = film_.opposite(s);
    for (int k = 0; is_flap(s.triangle()) && k < 3; ++k) {
      const Side other(s.triangle(), k);
      const Edge third = film_.edge_of(other).edge();
      if (third != e && third != edge_) apex = film_.opposite(film_.next_around(other));
    }
    directions.push_back(place_of(apex) - place_of(tail));
  });
  const double least = std::min(least_wedge, 0.9 * narrowest_wedge(film_, e));
  return turns_once(unit(axis), directions, least);
}

bool Shrinker::keeps_order() const {
  return std::all_of(around_.begin(), around_.end(), [&](Triangle t) {
    const auto& edges = film_.edges(t);
    return std::all_of(edges.begin(), edges.end(), [&](film::SignedEdge e) {
      return e.edge() == edge_ || film_.valence(e.edge()) < 3 || stays_in_order(e.edge());
    });
  });
}

bool Shrinker::keeps_clear() const {
  if (grid_ == nullptr) return true;
  std::vector<film::FacetShape> shapes;
  for (const Triangle t : around_) {
    if (is_flap(t)) continue;
    film::FacetShape shape{film_.corners(t), moved(t)};
    std::replace(shape.corners.begin(), shape.corners.end(), head_, tail_);
    shapes.push_back(shape);
  }
  return !grid_->crosses(shapes, around_);
}

// Of a film in motion: that of both ends together, as bodies that collide and stick.
Vec3 Shrinker::common_velocity() const {
  const auto velocities = film_.columns(film::ElementKind::vertex).reals("velocity");
  const auto masses = film_.columns(film::ElementKind::vertex).reals("mass");
  if (velocities.empty() || masses.empty()) return {};
  const double mass = masses[tail_.index] + masses[head_.index];
  const double share = mass > 0 ? masses[tail_.index] / mass : 0.5;
  Vec3 velocity;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    velocity[axis] = share * velocities[3 * tail_.index + k] + (1 - share) * velocities[3 * head_.index + k];
  }
  return velocity;
}

void Shrinker::set_velocity(Vertex v, const Vec3& velocity) {
  film::Column* const column = film_.columns(film::ElementKind::vertex).edit("velocity");
  if (column == nullptr) return;
  for (int axis = 0; axis < 3; ++axis) column->set(v.index, axis, velocity[axis]);
}

std::array<Vec3, 3> Shrinker::moved(Triangle t) const {
  auto p = film_.points(t);
  const auto& c = film_.corners(t);
  for (std::size_t k = 0; k < 3; ++k) {
    if (c[k] == tail_ || c[k] == head_) p[k] = target_;
  }
  return p;
}

bool Shrinker::keeps_shape() const {
  double worst = HUGE_VAL;
  for (const Triangle t : around_) {
    const Shape shape = shape_of(film_.points(t));
    if (shape.longest > 0) worst = std::min(worst, shape.altitude / shape.longest);
  }
  const double least = std::min(worst, good_altitude);
  return std::all_of(around_.begin(), around_.end(), [&](Triangle t) {
    if (is_flap(t)) return true;
    const Shape before = shape_of(film_.points(t));
    const Shape after = shape_of(moved(t));
    if (after.longest > std::max(longest_, before.longest)) return false;
    if (after.altitude < least * after.longest) return false;
    // The normal of a sliver says nothing.
    if (before.altitude < 0.02 * before.longest) return true;
    return dot(before.normal, after.normal) > least_cosine * length(before.normal) * length(after.normal);
  });
}

}  // namespace

Shrink shrink_edge(Scene& scene, Edge e, double longest, film::CrossingGrid* grid) {
  return Shrinker(scene, e, longest, grid).run();
}

}  // namespace lamella::surgery
