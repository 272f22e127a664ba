#include "surgery/zip.h"

#include <algorithm>
#include <cmath>

#include "film/intersections.h"
#include "surgery/contract.h"
#include "surgery/link.h"
#include "surgery/patch.h"
#include "surgery/strip.h"

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Region;
using film::RegionPair;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

constexpr auto at = &Link::index;
constexpr double least_altitude = 0.01;  // of new facets, in sizes

// A chain of facets around the vertex from one border edge to the other, with the vertices on its far side.
struct Fan {
  std::vector<Triangle> facets;
  std::vector<Vertex> far;
};

class Zipper {
 public:
  Zipper(Scene& scene, Vertex v, double size) : scene_(scene), film_(scene.film), centre_(v), size_(size) {}

  std::optional<Zip> run() {
    if (film_.periodic() || !film_.alive(centre_) || !is_free(scene_, centre_)) return {};
    link_ = link_of(film_, centre_);
    if (kind_of(link_) != LinkKind::triple || !pick()) return {};
    // Which fan stays makes a difference where one leans over: the other way is tried, too.
    for (int i = 0; i < 2; ++i) {
      if (auto done = commit()) return done;
      std::swap(stays_, goes_);
    }
    return {};
  }

 private:
  bool pick();
  Fan fan_from(int node, Link::ArcEnd start) const;
  double wedge(Link::ArcEnd a, Link::ArcEnd b) const;
  std::optional<Zip> commit();
  bool is_sound(std::span<const Triangle> made) const;

  Scene& scene_;
  Film& film_;
  Vertex centre_;
  double size_;
  Link link_;
  int gap_ = 0;  // the sector that closes
  Fan stays_;
  Fan goes_;
};

// The angle between two films that leave the vertex by one border edge.
double Zipper::wedge(Link::ArcEnd a, Link::ArcEnd b) const {
  const auto direction = [&](Link::ArcEnd end) {
    const Link::Arc& arc = link_.arcs[at(end.arc)];
    const Vec3 origin = film_.position(centre_);
    const Vec3 axis = unit(film_.position(link_.nodes[at(arc.node[at(end.end)])].outer) - origin);
    const Vec3 d = film_.position(link_.nodes[at(arc.node[at(1 - end.end)])].outer) - origin;
    return unit(d - dot(d, axis) * axis);
  };
  return angle_between(direction(a), direction(b));
}

Fan Zipper::fan_from(int node, Link::ArcEnd start) const {
  Fan fan;
  fan.far.push_back(link_.nodes[at(node)].outer);
  Link::ArcEnd along = start;
  for (std::size_t steps = 0; steps < link_.arcs.size(); ++steps) {
    const Link::Arc& arc = link_.arcs[at(along.arc)];
    fan.facets.push_back(arc.facet);
    const Link::Node& to = link_.nodes[at(arc.node[at(1 - along.end)])];
    fan.far.push_back(to.outer);
    if (to.degree() != 2) break;
    along = to.ends[0].arc == along.arc ? to.ends[1] : to.ends[0];
  }
  return fan;
}

bool Zipper::pick() {
  double least = M_PI;
  for (std::size_t n = 0; n < link_.nodes.size(); ++n) {
    const Link::Node& node = link_.nodes[n];
    for (std::size_t i = 0; node.degree() == 3 && i < 3; ++i) {
      const Link::ArcEnd a = node.ends[i];
      const Link::ArcEnd b = node.ends[(i + 1) % 3];
      const double angle = wedge(a, b);
      if (angle >= least) continue;
      least = angle;
      gap_ = link_.after(a);
      stays_ = fan_from(static_cast<int>(n), a);
      goes_ = fan_from(static_cast<int>(n), b);
    }
  }
  // Two fans of one facet each would become two facets with the same corners.
  return least < M_PI && stays_.far.size() + goes_.far.size() > 4 && stays_.far.back() == goes_.far.back();
}

bool Zipper::is_sound(std::span<const Triangle> made) const {
  for (const Triangle t : made) {
    const auto p = film_.points(t);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, length(p[(k + 1) % 3] - p[k]));
    if (length(cross(p[1] - p[0], p[2] - p[0])) < least_altitude * size_ * longest) return false;
    for (int k = 0; k < 3; ++k) {
      const Side s(t, k);
      if (film_.region_after(s) != film_.region_before(film_.next_around(s))) return false;
      if (film_.valence(film_.edge_of(s).edge()) > 3) return false;
    }
  }
  return film::self_intersections(film_, made, 1).empty();
}

std::optional<Zip> Zipper::commit() {
  // The vertices that get a new border must be inside their film.
  for (std::size_t i = 1; i + 1 < stays_.far.size(); ++i) {
    if (kind_of(link_of(film_, stays_.far[i])) != LinkKind::disc || !is_free(scene_, stays_.far[i]))
      return {};
  }
  const Region gap = link_.sectors[at(gap_)].region;
  const auto beyond = [&](int arc_sector_of) { return link_.sectors[at(arc_sector_of)].region; };
  const auto arc_of = [&](Triangle t) {
    return *std::find_if(link_.arcs.begin(), link_.arcs.end(),
                         [&](const Link::Arc& arc) { return arc.facet == t; });
  };
  const Link::Arc gone = arc_of(goes_.facets[0]);
  const Region far = beyond(gone.front == gap_ ? gone.behind : gone.front);
  // The band turns along the far side of the fan that goes: as its facets do where the gap is behind them.
  const bool along = gone.front != gap_;
  const bool same_way = link_.nodes[at(gone.node[0])].outer == goes_.far[0];
  std::vector<Vertex> outer = goes_.far;
  std::vector<Vertex> inner = stays_.far;
  if (along != same_way) {
    std::reverse(outer.begin(), outer.end());
    std::reverse(inner.begin(), inner.end());
  }
  const Strip strip = strip_between_lines(film_, inner, outer);
  double area = 0;
  for (const Triangle t : goes_.facets) {
    const auto p = film_.points(t);
    area += 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
  }
  if (strip.facets.empty() || strip.area > area) return {};

  const Film before = film_;
  Patch patch{goes_.facets, {}};
  for (const auto& corners : strip.facets) patch.made.push_back({corners, {far, gap}, goes_.facets[0]});
  std::vector<Triangle> made = replace(film_, patch);
  for (const Triangle t : stays_.facets) {
    const Link::Arc arc = arc_of(t);
    RegionPair pair = film_.regions(t);
    (arc.front == gap_ ? pair.front : pair.behind) = far;
    film_.set_regions(t, pair);
    made.push_back(t);
  }
  for (const Triangle t : stays_.facets) {
    for (const film::SignedEdge e : film_.edges(t)) film_.sort_sides(e.edge());
  }
  if (!is_sound(made)) {
    film_ = before;
    return {};
  }
  Zip done;
  done.touched = inner;
  done.touched.insert(done.touched.end(), outer.begin(), outer.end());
  done.touched.push_back(centre_);
  return done;
}

}  // namespace

std::optional<Zip> zip(Scene& scene, Vertex v, double size) {
  return Zipper(scene, v, size).run();
}

}  // namespace lamella::surgery
