#include "surgery/merge.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "film/intersections.h"
#include "film/normals.h"
#include "surgery/contract.h"
#include "surgery/feature.h"
#include "surgery/patch.h"
#include "surgery/strip.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Region;
using film::RegionPair;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

constexpr double close = 0.35;      // what lies within the gap and this much (in sizes) belongs to the patch
constexpr double sheet_radius = 5;  // of what is looked at of each sheet, in sizes
constexpr double least_altitude = 0.02;
constexpr double gain = 1e-3;  // least area to be won, in squares of the size

using Facets = std::set<Triangle>;
using Vertices = std::set<Vertex>;

double area_of(const Film& film, const Facets& facets) {
  double sum = 0;
  for (const Triangle t : facets) sum += 0.5 * length(film::double_area_vector(film, t));
  return sum;
}

// Facets around a place to be reached from one without crossing a line.
Facets sheet_around(const Scene& scene, Triangle start, const Vec3& place, double radius) {
  const Film& film = scene.film;
  Facets sheet{start};
  std::vector<Triangle> waiting{start};
  while (!waiting.empty()) {
    const Triangle t = waiting.back();
    waiting.pop_back();
    for (int k = 0; k < 3; ++k) {
      const Side s(t, k);
      if (is_line(scene, film.edge_of(s).edge())) continue;
      const Triangle other = film.next_around(s).triangle();
      if (length(film.points(other)[0] - place) < radius && sheet.insert(other).second)
        waiting.push_back(other);
    }
  }
  return sheet;
}

Vertices vertices_of(const Film& film, const Facets& facets) {
  Vertices vertices;
  for (const Triangle t : facets) vertices.insert(film.corners(t).begin(), film.corners(t).end());
  return vertices;
}

Facets stars_of(const Film& film, const Vertices& vertices) {
  Facets facets;
  for (const Vertex v : vertices) {
    for (const Triangle t : facets_at(film, std::span(&v, 1))) facets.insert(t);
  }
  return facets;
}

double distance_to(const Film& film, const Facets& facets, const Vec3& p, Triangle* nearest = nullptr) {
  double least = HUGE_VAL;
  for (const Triangle t : facets) {
    const double distance = length(p - nearest_point(film.points(t), p));
    if (distance >= least) continue;
    least = distance;
    if (nearest != nullptr) *nearest = t;
  }
  return least;
}

// A disc's rim as a loop of vertices, and for each facet whether it turns as the first does. Nothing unless
// the facets are a disc whose inner edges have two films.
struct Disc {
  std::vector<Vertex> rim;
  std::vector<Triangle> facets;
  std::vector<bool> turned;  // against the first
};

class DiscMaker {
 public:
  DiscMaker(const Film& film, const Facets& facets) : film_(film), facets_(facets) {}

  std::optional<Disc> make() {
    if (facets_.empty() || !orient() || !collect_rim() || !is_disc()) return {};
    return std::move(disc_);
  }

 private:
  bool orient();
  bool collect_rim();
  bool is_disc() const;
  bool is_rim(Side s) const {
    return !facets_.contains(film_.next_around(s).triangle()) || film_.next_around(s) == s;
  }
  std::size_t row(Triangle t) const {
    return static_cast<std::size_t>(std::find(disc_.facets.begin(), disc_.facets.end(), t) -
                                    disc_.facets.begin());
  }

  const Film& film_;
  const Facets& facets_;
  Disc disc_;
};

bool DiscMaker::orient() {
  disc_.facets.push_back(*facets_.begin());
  disc_.turned.push_back(false);
  for (std::size_t i = 0; i < disc_.facets.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Side s(disc_.facets[i], k);
      const Side other = film_.next_around(s);
      if (is_rim(s)) continue;
      if (film_.next_around(other) != s) return false;
      const bool opposed = film_.edge_of(s).reversed() != film_.edge_of(other).reversed();
      const bool turned = opposed ? disc_.turned[i] : !disc_.turned[i];
      const std::size_t at = row(other.triangle());
      if (at == disc_.facets.size()) {
        disc_.facets.push_back(other.triangle());
        disc_.turned.push_back(turned);
      } else if (disc_.turned[at] != turned) {
        return false;
      }
    }
  }
  return disc_.facets.size() == facets_.size();
}

// Each rim edge is walked as the first facet turns.
bool DiscMaker::collect_rim() {
  std::vector<std::pair<Vertex, Vertex>> steps;
  for (std::size_t i = 0; i < disc_.facets.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Side s(disc_.facets[i], k);
      if (!is_rim(s)) continue;
      Vertex from = film_.tail(film_.edge_of(s));
      Vertex to = film_.head(film_.edge_of(s));
      if (disc_.turned[i]) std::swap(from, to);
      steps.emplace_back(from, to);
    }
  }
  if (steps.size() < 3) return false;
  disc_.rim.push_back(steps[0].first);
  for (std::size_t n = 1; n <= steps.size(); ++n) {
    const Vertex at = disc_.rim.back();
    const auto step =
        std::find_if(steps.begin(), steps.end(), [&](const auto& each) { return each.first == at; });
    if (step == steps.end()) return false;
    if (step->second == disc_.rim[0]) return n == steps.size();
    disc_.rim.push_back(step->second);
  }
  return false;
}

bool DiscMaker::is_disc() const {
  std::set<Edge> edges;
  for (const Triangle t : facets_) {
    for (const film::SignedEdge e : film_.edges(t)) edges.insert(e.edge());
  }
  return vertices_of(film_, facets_).size() + facets_.size() == edges.size() + 1;
}

class Merger {
 public:
  Merger(Scene& scene, double size) : scene_(scene), film_(scene.film), size_(size) {}

  // The sheet of `seed` keeps its patch; that of `facet` opens.
  std::optional<Merge> run(Vertex seed, Triangle facet);

 private:
  bool is_open(Vertex v) const { return rank_of(scene_, v) == Rank::sheet && is_free(scene_, v); }
  bool all_open(const Vertices& vertices) const {
    return std::all_of(vertices.begin(), vertices.end(), [&](Vertex v) { return is_open(v); });
  }
  bool pick(Vertex seed, Triangle facet);
  Facets close_patch(Vertex seed, double gap) const;
  Vertices vertices_over(const Facets& p, double reach) const;
  std::optional<Merge> commit(const Facets& p, const Facets& q);
  // The region in which the way to the other sheet starts.
  Region beyond(Triangle t, bool turned, bool toward_front) const {
    const RegionPair pair = film_.regions(t);
    return turned != toward_front ? pair.front : pair.behind;
  }

  Scene& scene_;
  Film& film_;
  double size_;
  Vec3 place_;
  Vec3 way_;  // from the first sheet to the second
  Facets first_;
  Facets second_;
};

bool Merger::pick(Vertex seed, Triangle facet) {
  if (!film_.alive(seed) || !film_.alive(facet) || !is_open(seed)) return false;
  place_ = film_.position(seed);
  const Triangle start = film_.first_side(film_.first_end(seed).edge()).triangle();
  first_ = sheet_around(scene_, start, place_, sheet_radius * size_);
  second_ = sheet_around(scene_, facet, place_, sheet_radius * size_);
  way_ = nearest_point(film_.points(facet), place_) - place_;
  // Two parts of one sheet, near one another along it: a fold, or the inside of a neck, that has to wait.
  for (const Triangle t : facets_at(film_, std::span(&seed, 1))) {
    if (second_.contains(t)) {
      const Facets near_first = sheet_around(scene_, start, place_, 1.6 * size_);
      const Facets near_second = sheet_around(scene_, facet, place_ + way_, 1.6 * size_);
      for (const Triangle each : near_first) {
        if (near_second.contains(each)) return false;
      }
      first_ = near_first;
      second_ = near_second;
      break;
    }
  }
  return true;
}

// The facets of the first sheet close to the second, as far as they hang together with the seed.
Facets Merger::close_patch(Vertex seed, double gap) const {
  const double reach = gap + close * size_;
  Facets found;
  std::vector<Triangle> waiting = facets_at(film_, std::span(&seed, 1));
  const auto belongs = [&](Triangle t) {
    const auto& c = film_.corners(t);
    return first_.contains(t) && std::all_of(c.begin(), c.end(), [&](Vertex v) {
             return is_open(v) && distance_to(film_, second_, film_.position(v)) < reach;
           });
  };
  while (!waiting.empty()) {
    const Triangle t = waiting.back();
    waiting.pop_back();
    if (found.contains(t) || !belongs(t)) continue;
    found.insert(t);
    for (int k = 0; k < 3; ++k) waiting.push_back(film_.next_around(Side(t, k)).triangle());
  }
  return found;
}

// Vertices of the second sheet within reach of a patch, and the corners of the facets nearest to it.
Vertices Merger::vertices_over(const Facets& p, double reach) const {
  Vertices over;
  for (const Vertex v : vertices_of(film_, second_)) {
    if (distance_to(film_, p, film_.position(v)) < reach) over.insert(v);
  }
  for (const Vertex v : vertices_of(film_, p)) {
    Triangle nearest;
    distance_to(film_, second_, film_.position(v), &nearest);
    if (nearest.valid()) over.insert(film_.corners(nearest).begin(), film_.corners(nearest).end());
  }
  return over;
}

std::optional<Merge> Merger::commit(const Facets& p_facets, const Facets& q_facets) {
  std::optional<Disc> p = DiscMaker(film_, p_facets).make();
  std::optional<Disc> q = DiscMaker(film_, q_facets).make();
  if (!p || !q) return {};
  for (const Triangle t : q_facets) {
    if (p_facets.contains(t)) return {};
  }
  for (const Vertex v : p->rim) {
    if (std::find(q->rim.begin(), q->rim.end(), v) != q->rim.end()) return {};
  }
  // Seen along the way from the first sheet to the second.
  const bool p_front = dot(film::double_area_vector(film_, p->facets[0]), way_) > 0;
  const bool q_front = dot(film::double_area_vector(film_, q->facets[0]), way_) > 0;
  const Region gap = beyond(p->facets[0], false, p_front);
  const Region near = beyond(p->facets[0], false, !p_front);
  const Region far = beyond(q->facets[0], false, q_front);
  if (beyond(q->facets[0], false, !q_front) != gap) return {};
  std::vector<Vertex> inner = p->rim;
  std::vector<Vertex> outer = q->rim;
  if (!p_front) std::reverse(inner.begin(), inner.end());
  if (!q_front) std::reverse(outer.begin(), outer.end());
  const Strip strip = strip_between_loops(film_, inner, outer);
  const bool has_film = near != far || near.outside();
  const double won = area_of(film_, q_facets) - strip.area + (has_film ? 0 : area_of(film_, p_facets));
  if (won < gain * size_ * size_) return {};

  const Film before = film_;
  Merge result;
  result.event = {EventKind::merge, place_, {near, gap, far}};
  std::sort(result.event.regions.begin(), result.event.regions.end());
  result.event.regions.erase(std::unique(result.event.regions.begin(), result.event.regions.end()),
                             result.event.regions.end());
  Patch patch;
  patch.gone.assign(q_facets.begin(), q_facets.end());
  if (!has_film) patch.gone.insert(patch.gone.end(), p_facets.begin(), p_facets.end());
  for (const auto& corners : strip.facets) patch.made.push_back({corners, {far, gap}, q->facets[0]});
  std::vector<Triangle> made = replace(film_, patch);
  if (has_film) {
    for (std::size_t i = 0; i < p->facets.size(); ++i) {
      RegionPair pair = film_.regions(p->facets[i]);
      (p->turned[i] != p_front ? pair.front : pair.behind) = far;
      film_.set_regions(p->facets[i], pair);
      made.push_back(p->facets[i]);
    }
    for (std::size_t i = 0; i < p->rim.size(); ++i)
      film_.sort_sides(film_.find_edge(p->rim[i], p->rim[(i + 1) % p->rim.size()]).edge());
  }
  bool sound = true;
  for (const Triangle t : made) {
    const auto points = film_.points(t);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, length(points[(k + 1) % 3] - points[k]));
    sound = sound && length(film::double_area_vector(film_, t)) > least_altitude * size_ * longest;
    for (int k = 0; k < 3; ++k) {
      const Side s(t, k);
      sound = sound && film_.region_after(s) == film_.region_before(film_.next_around(s));
      if (film_.valence(film_.edge_of(s).edge()) > 3) sound = false;
    }
  }
  if (!sound || !film::self_intersections(film_, made, 1).empty()) {
    film_ = before;
    return {};
  }
  result.touched = outer;
  result.touched.insert(result.touched.end(), inner.begin(), inner.end());
  return result;
}

std::optional<Merge> Merger::run(Vertex seed, Triangle facet) {
  if (!pick(seed, facet)) return {};
  const double gap = length(way_);
  const std::vector<Triangle> star = facets_at(film_, std::span(&seed, 1));
  const Facets around(star.begin(), star.end());
  for (const Facets& p : {close_patch(seed, gap), around}) {
    if (p.empty() || !all_open(vertices_of(film_, p))) continue;
    const Vertices over = vertices_over(p, gap + close * size_);
    if (over.empty() || !all_open(over)) continue;
    if (auto done = commit(p, stars_of(film_, over))) return done;
  }
  return {};
}

}  // namespace

std::optional<Merge> merge(Scene& scene, const NearPair& pair, double size) {
  if (scene.film.periodic() || !scene.film.alive(pair.vertex) || !scene.film.alive(pair.facet)) return {};
  if (auto done = Merger(scene, size).run(pair.vertex, pair.facet)) return done;
  // With the roles swapped: from the corner of the facet nearest to the vertex.
  const Film& film = scene.film;
  const Vec3 p = film.position(pair.vertex);
  auto corners = film.corners(pair.facet);
  std::sort(corners.begin(), corners.end(), [&](Vertex a, Vertex b) {
    return squared_length(film.position(a) - p) < squared_length(film.position(b) - p);
  });
  const Facets star = stars_of(film, {pair.vertex});
  for (const Vertex corner : corners) {
    Triangle nearest;
    distance_to(film, star, film.position(corner), &nearest);
    if (!nearest.valid()) continue;
    if (auto done = Merger(scene, size).run(corner, nearest)) return done;
  }
  return {};
}

}  // namespace lamella::surgery
