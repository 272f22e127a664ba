#include "surgery/contract.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "film/crossing_grid.h"
#include "scene/constraint_sets.h"
#include "surgery/patch.h"
#include "surgery/trial.h"

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
// Copies move no farther from the cluster's centre than this part of the way to the nearest vertex around.
constexpr double reach = 0.7;
constexpr double start_reach = 0.12;  // where copies stand when a trial begins, in parts of their reach
constexpr int trial_steps = 200;
// What is done whatever the energy is not relaxed: it might only shrink back to nothing.
constexpr double forced_reach = 0.3;
constexpr int most_retries = 3;  // each halves the reach
constexpr std::size_t most_cluster = 40;
constexpr double least_altitude = 0.02;  // in units of the size

struct Tried {
  Rearrangement how;
  double energy = 0;
  std::vector<Vec3> places;  // of the copies
};

class Contractor {
 public:
  Contractor(Scene& scene, std::span<const Vertex> cluster, const ContractOptions& options)
      : scene_(scene), film_(scene.film), cluster_(cluster.begin(), cluster.end()), options_(options) {}

  std::optional<Contraction> run();

 private:
  bool pick();
  bool forced() const { return std::isinf(options_.gain); }
  int steps() const { return forced() ? 0 : trial_steps; }
  double pressure(Region r) const { return r.outside() ? 0 : scene_.body(r).pressure; }
  TrialFacet trial_facet(std::array<int, 3> corners, RegionPair regions, Triangle like) const;
  double energy_as_it_is();
  bool vanishes_with_volume() const;
  TrialFilm trial_of(const Rearrangement& r, double radius) const;
  bool is_simple(const Rearrangement& r) const;
  std::vector<Tried> rank();
  bool commit(const Tried& tried, double radius, Contraction& done);
  bool keeps_clear(const Tried& tried, const TrialFilm& trial);
  bool labels_agree(std::span<const Vertex> copies) const;
  Event event_of(const Tried& tried) const;

  Scene& scene_;
  Film& film_;
  std::vector<Vertex> cluster_;
  ContractOptions options_;
  Link link_;
  Vec3 centre_;
  double radius_ = 0;
  double before_ = 0;
  std::vector<Triangle> star_;
  std::optional<film::CrossingGrid> own_grid_;
};

bool Contractor::pick() {
  if (film_.periodic() || cluster_.empty() || cluster_.size() > most_cluster) return false;
  for (const Vertex v : cluster_) {
    if (!film_.alive(v) || !is_free(scene_, v)) return false;
    centre_ += film_.position(v) / static_cast<double>(cluster_.size());
  }
  link_ = link_of(film_, cluster_);
  if (!link_.sound || link_.has_wires || link_.nodes.empty()) return false;
  star_ = facets_at(film_, cluster_);
  for (const Triangle t : star_) {
    if (is_fixed(film_, film::ElementKind::facet, t.index)) return false;
  }
  radius_ = HUGE_VAL;
  for (const Link::Node& node : link_.nodes)
    radius_ = std::min(radius_, length(film_.position(node.outer) - centre_));
  radius_ *= reach;
  return radius_ > 0 && !vanishes_with_volume();
}

// Whether a region that must keep a volume would be gone.
bool Contractor::vanishes_with_volume() const {
  for (const Region r : regions_at(film_, star_)) {
    const bool stays = std::any_of(link_.sectors.begin(), link_.sectors.end(),
                                   [&](const Link::Sector& sector) { return sector.region == r; });
    if (!stays && !r.outside() && r != options_.vanishes && scene_.body(r).fixed_volume() &&
        *scene_.body(r).target_volume > 0)
      return true;
  }
  return false;
}

TrialFacet Contractor::trial_facet(std::array<int, 3> corners, RegionPair regions, Triangle like) const {
  return {corners, scene::tension(scene_, like), pressure(regions.behind) - pressure(regions.front)};
}

// Of the facets around the cluster, with its vertices where they are or, if that is less, relaxed.
double Contractor::energy_as_it_is() {
  TrialFilm trial;
  std::vector<Vertex> vertices = cluster_;
  const auto index_of = [&](Vertex v) {
    const auto found = std::find(vertices.begin(), vertices.end(), v);
    if (found != vertices.end()) return static_cast<int>(found - vertices.begin());
    vertices.push_back(v);
    return static_cast<int>(vertices.size()) - 1;
  };
  for (const Triangle t : star_) {
    const auto& c = film_.corners(t);
    trial.facets.push_back(
        trial_facet({index_of(c[0]), index_of(c[1]), index_of(c[2])}, film_.regions(t), t));
  }
  trial.free = static_cast<int>(cluster_.size());
  for (const Vertex v : vertices) trial.points.push_back(film_.position(v) - centre_);
  return std::min(energy(trial), relax(trial, {}, radius_, steps()));
}

// No copy has two edges to one vertex.
bool Contractor::is_simple(const Rearrangement& r) const {
  std::set<std::pair<int, int>> spokes;
  for (std::size_t a = 0; a < link_.arcs.size(); ++a) {
    for (const int node : link_.arcs[a].node) spokes.emplace(r.copy_of_arc[a], node);
  }
  for (const Piece& piece : r.films) {
    for (const Corner& from : piece.corners) {
      for (const Corner& to : piece.corners) {
        if (from.copy >= 0 && to.node >= 0) spokes.emplace(from.copy, to.node);
      }
    }
  }
  std::set<std::pair<int, std::uint32_t>> edges;
  return std::all_of(spokes.begin(), spokes.end(), [&](const auto& spoke) {
    return edges.emplace(spoke.first, link_.nodes[at(spoke.second)].outer.index).second;
  });
}

// Points: the copies, then one for each node. Places are relative to the centre.
TrialFilm Contractor::trial_of(const Rearrangement& r, double radius) const {
  TrialFilm trial;
  trial.free = r.copies;
  const std::size_t copies = at(r.copies);
  trial.points.resize(copies + link_.nodes.size());
  for (std::size_t n = 0; n < link_.nodes.size(); ++n)
    trial.points[copies + n] = film_.position(link_.nodes[n].outer) - centre_;
  const auto point = [&](const Corner& c) { return c.copy >= 0 ? c.copy : r.copies + c.node; };
  std::vector<Vec3> way(copies);
  std::vector<double> count(copies);
  const auto lean = [&](int copy, int to) {
    way[at(copy)] += unit(trial.points[at(to)]);
    count[at(copy)] += 1;
  };
  for (std::size_t a = 0; a < link_.arcs.size(); ++a) {
    const Link::Arc& arc = link_.arcs[a];
    const int copy = r.copy_of_arc[a];
    const std::array<int, 2> ends{r.copies + arc.node[0], r.copies + arc.node[1]};
    trial.facets.push_back(trial_facet({copy, ends[0], ends[1]}, film_.regions(arc.facet), arc.facet));
    for (const int end : ends) lean(copy, end);
  }
  for (const Piece& piece : r.films) {
    trial.facets.push_back(
        trial_facet({point(piece.corners[0]), point(piece.corners[1]), point(piece.corners[2])},
                    piece.regions, piece.like));
  }
  for (std::size_t c = 0; c < copies; ++c) {
    if (count[c] > 0)
      trial.points[c] = ((forced() ? forced_reach : start_reach) * radius / count[c]) * way[c];
  }
  return trial;
}

std::vector<Tried> Contractor::rank() {
  std::vector<Tried> list;
  for (Rearrangement& r : rearrangements(link_)) {
    if (options_.only && r.move != *options_.only) continue;
    if (!is_simple(r) || (r.move == Move::keep && cluster_.size() == 1)) continue;
    TrialFilm trial = trial_of(r, radius_);
    Tried tried{std::move(r), relax(trial, {}, radius_, steps()), {}};
    tried.places.assign(trial.points.begin(), trial.points.begin() + trial.free);
    list.push_back(std::move(tried));
  }
  std::sort(list.begin(), list.end(), [](const Tried& a, const Tried& b) { return a.energy < b.energy; });
  return list;
}

// Around the new edges. Elsewhere they may lawfully disagree: at wires of bodies that are open.
bool Contractor::labels_agree(std::span<const Vertex> copies) const {
  bool agree = true;
  for (const Vertex v : copies) {
    film_.for_each_end(v, [&](film::EdgeEnd end) {
      film_.for_each_side(end.edge(), [&](Side s) {
        agree = agree && film_.region_after(s) == film_.region_before(film_.next_around(s));
      });
    });
  }
  return agree;
}

// Whether the new facets, which are those of the trial, pass through nothing.
bool Contractor::keeps_clear(const Tried& tried, const TrialFilm& trial) {
  const auto vertex = [&](int point) {
    return point < tried.how.copies ? Vertex(film_.vertex_rows() + static_cast<std::uint32_t>(point))
                                    : link_.nodes[at(point - tried.how.copies)].outer;
  };
  std::vector<film::FacetShape> shapes;
  for (const TrialFacet& facet : trial.facets) {
    film::FacetShape shape;
    for (std::size_t k = 0; k < 3; ++k) {
      shape.corners[k] = vertex(facet.corners[k]);
      shape.points[k] = centre_ + trial.points[at(facet.corners[k])];
    }
    shapes.push_back(shape);
  }
  std::optional<film::CrossingGrid>& grid = options_.grid != nullptr ? *options_.grid : own_grid_;
  if (!grid) grid.emplace(film_);
  return !grid->crosses(shapes, star_);
}

bool Contractor::commit(const Tried& tried, double radius, Contraction& done) {
  TrialFilm trial = trial_of(tried.how, radius);
  double left = energy(trial);
  if (radius == radius_) {
    std::copy(tried.places.begin(), tried.places.end(), trial.points.begin());
    left = tried.energy;
  } else {
    left = relax(trial, {}, radius, steps());
  }
  const double sigma_size = options_.size * options_.size;
  if (left > before_ - options_.gain * sigma_size) return false;
  if (smallest_altitude(trial) < least_altitude * options_.size || !keeps_clear(tried, trial)) return false;

  const Film before = film_;
  std::vector<Vertex> copies;
  for (int c = 0; c < tried.how.copies; ++c)
    copies.push_back(copy_vertex(film_, cluster_[at(c) % cluster_.size()], centre_ + trial.points[at(c)]));
  const auto vertex = [&](const Corner& c) {
    return c.copy >= 0 ? copies[at(c.copy)] : link_.nodes[at(c.node)].outer;
  };
  Patch patch{star_, {}};
  struct Spoke {
    Vertex from;
    Vertex to;
    Edge old;
  };
  std::vector<Spoke> spokes;
  for (std::size_t a = 0; a < link_.arcs.size(); ++a) {
    const Link::Arc& arc = link_.arcs[a];
    const Vertex copy = copies[at(tried.how.copy_of_arc[a])];
    const Vertex u = link_.nodes[at(arc.node[0])].outer;
    const Vertex w = link_.nodes[at(arc.node[1])].outer;
    patch.made.push_back({{copy, u, w}, film_.regions(arc.facet), arc.facet});
    spokes.push_back({copy, u, film_.find_edge(arc.at, u).edge()});
    spokes.push_back({copy, w, film_.find_edge(arc.at, w).edge()});
  }
  for (const Piece& p : tried.how.films)
    patch.made.push_back(
        {{vertex(p.corners[0]), vertex(p.corners[1]), vertex(p.corners[2])}, p.regions, p.like});
  replace(film_, patch);
  for (const Spoke& spoke : spokes) film_.inherit(film_.find_edge(spoke.from, spoke.to).edge(), spoke.old);
  if (!labels_agree(copies)) {
    film_ = before;
    return false;
  }
  if (options_.grid != nullptr) {
    for (const Vertex v : copies) (*options_.grid)->add_around(v);
  }
  done = {event_of(tried), before_ - left, copies};
  return true;
}

Event Contractor::event_of(const Tried& tried) const {
  Event event{EventKind::t1, centre_, {}};
  for (const Link::Sector& sector : link_.sectors) event.regions.push_back(sector.region);
  std::sort(event.regions.begin(), event.regions.end());
  event.regions.erase(std::unique(event.regions.begin(), event.regions.end()), event.regions.end());
  if (tried.how.move == Move::apart) event.kind = EventKind::pinch;
  if (tried.how.move == Move::keep) event.kind = EventKind::vanish;
  if (cluster_.size() == 1 && tried.how.move != Move::apart) event.kind = EventKind::pop;
  return event;
}

std::optional<Contraction> Contractor::run() {
  if (!pick()) return {};
  before_ = energy_as_it_is();
  for (const Tried& tried : rank()) {
    if (tried.energy > before_ - options_.gain * options_.size * options_.size) break;
    double radius = radius_;
    for (int tries = 0; tries <= most_retries; ++tries, radius *= 0.5) {
      Contraction done;
      if (commit(tried, radius, done)) return done;
    }
  }
  return {};
}

}  // namespace

bool is_free(const Scene& scene, Vertex v) {
  return !is_fixed(scene.film, film::ElementKind::vertex, v.index) &&
         scene::boundary_of(scene, film::ElementKind::vertex, v.index) == 0 &&
         scene::constraints_of(scene, film::ElementKind::vertex, v.index).empty();
}

std::optional<Contraction> contract(Scene& scene, std::span<const Vertex> cluster,
                                    const ContractOptions& options) {
  return Contractor(scene, cluster, options).run();
}

}  // namespace lamella::surgery
