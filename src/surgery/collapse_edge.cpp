#include "surgery/collapse_edge.h"

#include <algorithm>
#include <array>
#include <map>

#include "scene/constraint_sets.h"
#include "surgery/patch.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

std::vector<int> sorted_constraints(const Scene& scene, ElementKind kind, std::uint32_t row) {
  std::vector<int> numbers = scene::constraints_of(scene, kind, row);
  for (int& number : numbers) number = std::abs(number);
  // Constraints that hold everything hold the edge as well.
  std::erase_if(numbers, [&](int number) { return scene.level_sets.at(number).global; });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

// Whether an end of an edge may move along it: nothing holds the end that does not hold the edge.
bool may_move(const Scene& scene, Vertex v, Edge e) {
  return !is_fixed(scene.film, ElementKind::vertex, v.index) &&
         sorted_constraints(scene, ElementKind::vertex, v.index) ==
             sorted_constraints(scene, ElementKind::edge, e.index) &&
         scene::boundary_of(scene, ElementKind::vertex, v.index) ==
             scene::boundary_of(scene, ElementKind::edge, e.index);
}

// How much holds an edge: of two that become one, the one that is held more stays.
std::size_t hold(const Scene& scene, Edge e) {
  const bool on_boundary = scene::boundary_of(scene, ElementKind::edge, e.index) != 0;
  return (is_fixed(scene.film, ElementKind::edge, e.index) ? 100U : 0U) + (on_boundary ? 10U : 0U) +
         sorted_constraints(scene, ElementKind::edge, e.index).size();
}

// One facet around the edge, with its other two sides.
struct Flap {
  Triangle facet;
  Vertex apex;
  Side kept;
  Side gone;
};

class Collapser {
 public:
  Collapser(Scene& scene, Edge edge) : scene_(scene), film_(scene.film), edge_(edge) {}

  Collapse run() {
    if (is_fixed(film_, ElementKind::edge, edge_.index) || !choose_end()) return Collapse::held;
    if (kept_ == gone_) return Collapse::blocked;
    bring_together();
    find_flaps();
    if (!is_allowed()) return Collapse::blocked;
    collapse();
    return Collapse::done;
  }

 private:
  bool choose_end();
  void bring_together();
  void find_flaps();
  bool is_allowed();
  bool neighbours_allow() const;
  bool facets_allow() const;
  bool is_flap_edge(Edge e) const;
  bool is_apex(Vertex v) const;
  void collapse();
  void move_vertex();
  std::vector<Side> joined_ring(const Flap& flap) const;
  std::vector<Side> others_around(Side side) const;

  Scene& scene_;
  Film& film_;
  Edge edge_;
  Vertex kept_;
  Vertex gone_;
  bool halfway_ = false;
  std::vector<Flap> flaps_;
};

bool Collapser::choose_end() {
  const auto [tail, head] = film_.ends(edge_);
  const bool tail_moves = may_move(scene_, tail, edge_);
  const bool head_moves = may_move(scene_, head, edge_);
  if (!tail_moves && !head_moves) return false;
  kept_ = head_moves ? tail : head;
  gone_ = head_moves ? head : tail;
  halfway_ = tail_moves && head_moves;
  return true;
}

// In a periodic film, so that the ends and the corners opposite to the edge lie in one cell and edges that
// become one agree.
void Collapser::bring_together() {
  if (!film_.periodic()) return;
  const SignedEdge edge(edge_, film_.ends(edge_)[0] != kept_);
  film_.move_by_periods(gone_, film_.wrap(edge));
  film_.for_each_side(edge_, [&](Side s) {
    const SignedEdge to_apex(
        film_.edges(s.triangle())[static_cast<std::size_t>(film::next_corner(s.corner()))]);
    film_.move_by_periods(film_.opposite(s), film_.wrap(to_apex));
  });
}

void Collapser::find_flaps() {
  flaps_.clear();
  film_.for_each_side(edge_, [&](Side s) {
    const Side after(s.triangle(), film::next_corner(s.corner()));
    const Side before(s.triangle(), film::previous_corner(s.corner()));
    const bool along = !film_.edge_of(s).reversed();
    Flap flap{s.triangle(), film_.opposite(s), along ? after : before, along ? before : after};
    if (hold(scene_, film_.edge_of(flap.gone).edge()) > hold(scene_, film_.edge_of(flap.kept).edge()))
      std::swap(flap.kept, flap.gone);
    flaps_.push_back(flap);
  });
}

bool Collapser::is_flap_edge(Edge e) const {
  return std::any_of(flaps_.begin(), flaps_.end(), [&](const Flap& flap) {
    return film_.edge_of(flap.kept).edge() == e || film_.edge_of(flap.gone).edge() == e;
  });
}

bool Collapser::is_apex(Vertex v) const {
  return std::any_of(flaps_.begin(), flaps_.end(), [&](const Flap& flap) { return flap.apex == v; });
}

// No neighbour of both ends but the corners opposite to the edge, and each of these once.
bool Collapser::neighbours_allow() const {
  for (std::size_t i = 0; i < flaps_.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (flaps_[i].apex == flaps_[k].apex) return false;
    }
    if (flaps_[i].apex == kept_ || flaps_[i].apex == gone_) return false;
  }
  bool allowed = true;
  std::vector<Vertex> around_kept;
  film_.for_each_end(kept_, [&](EdgeEnd end) {
    const Vertex other = film_.head(end.outward());
    if (end.edge() == edge_ || is_flap_edge(end.edge())) return;
    allowed = allowed && other != gone_ && other != kept_ && !is_apex(other);
    around_kept.push_back(other);
  });
  film_.for_each_end(gone_, [&](EdgeEnd end) {
    const Vertex other = film_.head(end.outward());
    if (end.edge() == edge_ || is_flap_edge(end.edge())) return;
    allowed = allowed && other != gone_ && !is_apex(other) &&
              std::find(around_kept.begin(), around_kept.end(), other) == around_kept.end();
  });
  return allowed;
}

// No two facets between the same two opposite corners, one at either end.
bool Collapser::facets_allow() const {
  const auto spans = [&](Vertex at) {
    std::vector<std::pair<Vertex, Vertex>> found;
    film_.for_each_end(at, [&](EdgeEnd end) {
      film_.for_each_side(end.edge(), [&](Side s) {
        if (film_.tail(film_.edge_of(s)) != at) return;
        const auto& corners = film_.corners(s.triangle());
        std::array<Vertex, 2> others{corners[static_cast<std::size_t>(film::next_corner(s.corner()))],
                                     corners[static_cast<std::size_t>(film::previous_corner(s.corner()))]};
        std::sort(others.begin(), others.end());
        if (is_apex(others[0]) && is_apex(others[1])) found.emplace_back(others[0], others[1]);
      });
    });
    return found;
  };
  const auto at_kept = spans(kept_);
  const auto at_gone = spans(gone_);
  return std::none_of(at_gone.begin(), at_gone.end(), [&](const auto& pair) {
    return std::find(at_kept.begin(), at_kept.end(), pair) != at_kept.end();
  });
}

bool Collapser::is_allowed() {
  return neighbours_allow() && facets_allow();
}

// The other sides around the edge of this one, from the next on, counterclockwise about the direction away
// from the facet's corner opposite to the edge that collapses.
std::vector<Side> Collapser::others_around(Side side) const {
  std::vector<Side> others;
  for (Side s = film_.next_around(side); s != side; s = film_.next_around(s)) others.push_back(s);
  const Vertex near = film_.ends(film_.edge_of(side).edge())[0];
  if (near == kept_ || near == gone_) std::reverse(others.begin(), others.end());
  return others;
}

// The films that meet in the edge that stays. Where the facet vanishes from its ring, those around the other
// edge step in: what is behind the facet at one side is in front of it at the other.
std::vector<Side> Collapser::joined_ring(const Flap& flap) const {
  std::vector<Side> ring = others_around(flap.kept);
  const std::vector<Side> more = others_around(flap.gone);
  ring.insert(ring.end(), more.begin(), more.end());
  const Vertex near = film_.ends(film_.edge_of(flap.kept).edge())[0];
  if (near == kept_ || near == gone_) std::reverse(ring.begin(), ring.end());
  return ring;
}

void Collapser::move_vertex() {
  const Vec3 middle = 0.5 * (film_.position(kept_) + film_.position(gone_));
  if (halfway_) film_.move(kept_, middle);
  film_.columns(ElementKind::vertex).edit_each([&](film::Column& column) {
    const auto merge = column.inheritance.on_merge;
    const bool mean =
        merge == film::Inheritance::Merge::mean || (halfway_ && column.name == scene::parameter_column);
    if (mean) column.set_mean(kept_.index, gone_.index, kept_.index);
    if (merge != film::Inheritance::Merge::sum) return;
    for (int k = 0; k < column.width; ++k)
      column.set(kept_.index, k, column.value(kept_.index, k) + column.value(gone_.index, k));
  });
}

void Collapser::collapse() {
  // What replaces the edges that vanish, and the rings of those that stay.
  std::map<Edge, SignedEdge> replaced;
  std::vector<std::pair<Edge, std::vector<Side>>> rings;
  for (const Flap& flap : flaps_) {
    const SignedEdge kept = film_.edge_of(flap.kept);
    const SignedEdge gone = film_.edge_of(flap.gone);
    const bool kept_outward = film_.ends(kept.edge())[0] == flap.apex;
    const bool gone_outward = film_.ends(gone.edge())[0] == flap.apex;
    replaced[gone.edge()] = SignedEdge(kept.edge(), kept_outward != gone_outward);
    rings.emplace_back(kept.edge(), joined_ring(flap));
  }
  std::vector<Triangle> touched;
  const auto touch = [&](Edge e) {
    film_.for_each_side(e, [&](Side s) { touched.push_back(s.triangle()); });
  };
  film_.for_each_end(gone_, [&](EdgeEnd end) { touch(end.edge()); });
  for (const auto& [gone, kept] : replaced) touch(gone);
  move_vertex();
  for (const Flap& flap : flaps_) film_.remove(flap.facet);
  std::vector<EdgeEnd> ends;
  film_.for_each_end(gone_, [&](EdgeEnd end) { ends.push_back(end); });
  for (const EdgeEnd end : ends) {
    if (end.edge() != edge_ && !replaced.contains(end.edge())) film_.reattach(end, kept_);
  }
  for (const Triangle t : touched) {
    if (!film_.alive(t)) continue;
    std::array<SignedEdge, 3> edges = film_.edges(t);
    for (SignedEdge& e : edges) {
      const auto at = replaced.find(e.edge());
      if (at != replaced.end()) e = e.reversed() ? -at->second : at->second;
    }
    film_.rewrite(t, edges);
  }
  for (const auto& [gone, kept] : replaced) {
    film_.set_ring(gone, {});
    film_.remove(gone);
  }
  for (const auto& [edge, ring] : rings) film_.set_ring(edge, ring);
  film_.remove(edge_);
  film_.remove(gone_);
}

// A vertex inside a facet that three others share: its edges and, between them, three facets. Its edge to
// `far` collapses into a vertex that stands in the way if it is one of the ends' common neighbours.
bool is_star(const Film& film, Vertex centre) {
  int edges = 0;
  bool inside = true;
  film.for_each_end(centre, [&](EdgeEnd end) {
    ++edges;
    inside = inside && film.valence(end.edge()) == 2;
  });
  return inside && edges == 3;
}

// Removes the vertices that stand between the ends of an edge and a common neighbour. True if there were any.
bool remove_stars(Scene& scene, Edge edge) {
  Film& film = scene.film;
  std::vector<Vertex> centres;
  film.for_each_side(edge, [&](Side s) {
    if (is_star(film, film.opposite(s))) centres.push_back(film.opposite(s));
  });
  bool any = false;
  for (const Vertex centre : centres) {
    if (is_fixed(film, ElementKind::vertex, centre.index) || !film.alive(edge)) continue;
    Edge outer;
    film.for_each_end(centre, [&](EdgeEnd end) {
      const Vertex other = film.head(end.outward());
      if (other != film.ends(edge)[0] && other != film.ends(edge)[1]) outer = end.edge();
    });
    if (!outer.valid()) continue;
    const Vertex far = film.ends(outer)[film.ends(outer)[0] == centre ? 1 : 0];
    const Vec3 place = film.position(far);
    if (Collapser(scene, outer).run() != Collapse::done) continue;
    any = true;
    film.move(film.alive(far) ? far : centre, place);
  }
  return any;
}

}  // namespace

Collapse collapse_edge(Scene& scene, Edge edge) {
  const Collapse first = Collapser(scene, edge).run();
  if (first != Collapse::blocked) return first;
  const Film before = scene.film;
  if (!remove_stars(scene, edge)) return first;
  const Collapse second = Collapser(scene, edge).run();
  if (second != Collapse::done) scene.film = before;
  return second;
}

Collapse collapse_facet(Scene& scene, Triangle facet) {
  const Film& film = scene.film;
  std::array<Edge, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) sides[k] = film.edges(facet)[k].edge();
  const auto length_of = [&](Edge e) { return length(film.vector(e)); };
  std::stable_sort(sides.begin(), sides.end(), [&](Edge a, Edge b) { return length_of(a) < length_of(b); });
  Collapse outcome = Collapse::held;
  for (const Edge side : sides) {
    outcome = collapse_edge(scene, side);
    if (outcome == Collapse::done) break;
  }
  return outcome;
}

}  // namespace lamella::surgery
