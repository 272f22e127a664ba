#include "surgery/refine.h"

#include <array>
#include <vector>

#include "film/ring.h"

namespace lamella::surgery {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::no_index;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// What became of each old edge: its middle and its half at the head, or nothing if it was left whole.
struct Halved {
  Vertex middle;
  Edge head_half;
  bool done() const { return middle.valid(); }
};

// One triangle of the new film and the old one it comes from.
struct Part {
  std::array<SignedEdge, 3> edges;
  Triangle whole;
};

// Builds the refined film beside the old one.
class Refiner {
 public:
  // No flags: every edge is to be halved.
  Refiner(Film& film, std::span<const std::uint8_t> halve) : old_(film), film_(film), halve_(halve) {}

  RefineCounts run() {
    halve_edges();
    cut_facets();
    write();
    return counts_;
  }

 private:
  void halve_edges();
  void cut_facets();
  void cut_in_four(Triangle t);
  void cut_in_three(Triangle t, int whole_side);
  void cut_in_two(Triangle t, int halved_side);
  void write();
  SignedEdge tail_half(SignedEdge e) const;
  SignedEdge head_half(SignedEdge e) const;
  Edge add_inner(Vertex from, Vertex to, Triangle inside, const Vec3& along);
  void wrap_edges();
  void begin_rings();
  Vertex middle(SignedEdge e) const { return halved_[e.edge().index].middle; }

  const Film old_;  // shares the arrays until the film is changed
  Film& film_;
  std::span<const std::uint8_t> halve_;
  std::vector<Halved> halved_;
  std::vector<std::array<Vertex, 2>> edge_ends_;
  std::vector<Vec3> positions_;
  std::vector<Triangle> inside_;  // of the inner edges, in their order
  std::vector<Vec3> along_;       // and their vectors, in a periodic film
  std::vector<Part> kept_;        // the part that keeps each facet's number
  std::vector<Part> added_;
  RefineCounts counts_;
};

// The half that a walk along `e` meets first, and the one it meets last.
SignedEdge Refiner::tail_half(SignedEdge e) const {
  return e.reversed() ? SignedEdge(halved_[e.edge().index].head_half, true) : e;
}

SignedEdge Refiner::head_half(SignedEdge e) const {
  return e.reversed() ? e : SignedEdge(halved_[e.edge().index].head_half, false);
}

Edge Refiner::add_inner(Vertex from, Vertex to, Triangle inside, const Vec3& along) {
  edge_ends_.push_back({from, to});
  inside_.push_back(inside);
  if (old_.periodic()) along_.push_back(along);
  return Edge(edge_ends_.size() - 1);
}

void Refiner::halve_edges() {
  const std::uint32_t edges = old_.edge_rows();
  const auto keep_whole = old_.columns(ElementKind::edge).flags("no_refine");
  positions_.assign(old_.positions().begin(), old_.positions().end());
  halved_.resize(edges);
  edge_ends_.resize(edges);
  for (std::uint32_t i = 0; i < edges; ++i) {
    const auto& ends = old_.ends(Edge(i));
    edge_ends_[i] = ends;
    if (!keep_whole.empty() && keep_whole[i] != 0) continue;
    if (!halve_.empty() && halve_[i] == 0) continue;
    halved_[i].middle = Vertex(positions_.size());
    halved_[i].head_half = Edge(edges + counts_.edges);
    positions_.push_back(old_.periodic() ? old_.position(ends[0]) + 0.5 * old_.vector(Edge(i))
                                         : 0.5 * (old_.position(ends[0]) + old_.position(ends[1])));
    edge_ends_[i][1] = halved_[i].middle;
    ++counts_.edges;
  }
  edge_ends_.reserve(edges + counts_.edges + 3 * std::size_t{old_.triangle_rows()});
  for (std::uint32_t i = 0; i < edges; ++i) {
    if (halved_[i].done()) edge_ends_.push_back({halved_[i].middle, old_.ends(Edge(i))[1]});
  }
}

void Refiner::cut_facets() {
  const std::uint32_t facets = old_.triangle_rows();
  kept_.reserve(facets);
  added_.reserve(3 * std::size_t{facets});
  for (std::uint32_t i = 0; i < facets; ++i) {
    const Triangle t(i);
    int halved = 0;
    int last_halved = 0;
    int last_whole = 0;
    for (int k = 0; k < 3; ++k) {
      const bool done = halved_[old_.edges(t)[static_cast<std::size_t>(k)].edge().index].done();
      halved += done ? 1 : 0;
      (done ? last_halved : last_whole) = k;
    }
    if (halved > 0) ++counts_.facets;
    switch (halved) {
      case 0:
        kept_.push_back({old_.edges(t), t});
        break;
      case 1:
        cut_in_two(t, last_halved);
        break;
      case 2:
        cut_in_three(t, last_whole);
        break;
      default:
        cut_in_four(t);
    }
  }
}

void Refiner::cut_in_four(Triangle t) {
  const auto& e = old_.edges(t);
  const std::array<Vec3, 3> p = old_.points(t);
  // inner[k] cuts off corner k: from the middle of side k to the middle of side k-1 (for k = 0), else from
  // the middle of the side that ends there to the middle of the one before; the directions are Evolver's.
  const Edge cut0 = add_inner(middle(e[0]), middle(e[2]), t, 0.5 * (p[2] - p[1]));
  const Edge cut1 = add_inner(middle(e[1]), middle(e[0]), t, 0.5 * (p[0] - p[2]));
  const Edge cut2 = add_inner(middle(e[2]), middle(e[1]), t, 0.5 * (p[1] - p[0]));
  kept_.push_back({{SignedEdge(cut2, true), SignedEdge(cut0, true), SignedEdge(cut1, true)}, t});
  added_.push_back({{tail_half(e[0]), SignedEdge(cut0, false), head_half(e[2])}, t});
  added_.push_back({{head_half(e[0]), tail_half(e[1]), SignedEdge(cut1, false)}, t});
  added_.push_back({{SignedEdge(cut2, false), head_half(e[1]), tail_half(e[2])}, t});
}

// With side b-c whole and the middles m of a-b and n of c-a: corner (a, m, n), then the shorter diagonal of
// the rest.
void Refiner::cut_in_three(Triangle t, int whole_side) {
  const auto side = [&](int k) { return old_.edges(t)[static_cast<std::size_t>(k % 3)]; };
  const SignedEdge bc = side(whole_side);
  const SignedEdge ca = side(whole_side + 1);
  const SignedEdge ab = side(whole_side + 2);
  const Vertex m = middle(ab);
  const Vertex n = middle(ca);
  const Vertex b = old_.tail(bc);
  const Vertex c = old_.head(bc);
  const std::array<Vec3, 3> points = old_.points(t);
  const auto point = [&](int k) { return points[static_cast<std::size_t>(k % 3)]; };
  const Vec3 at_b = point(whole_side);
  const Vec3 at_c = point(whole_side + 1);
  const Vec3 at_m = 0.5 * (point(whole_side + 2) + at_b);
  const Vec3 at_n = 0.5 * (at_c + point(whole_side + 2));
  const Edge mn = add_inner(m, n, t, at_n - at_m);
  kept_.push_back({{tail_half(ab), SignedEdge(mn, false), head_half(ca)}, t});
  if (squared_length(at_m - at_c) <= squared_length(at_b - at_n)) {
    const Edge mc = add_inner(m, c, t, at_c - at_m);
    added_.push_back({{head_half(ab), bc, SignedEdge(mc, true)}, t});
    added_.push_back({{SignedEdge(mc, false), tail_half(ca), SignedEdge(mn, true)}, t});
  } else {
    const Edge bn = add_inner(b, n, t, at_n - at_b);
    added_.push_back({{head_half(ab), SignedEdge(bn, false), SignedEdge(mn, true)}, t});
    added_.push_back({{bc, tail_half(ca), SignedEdge(bn, true)}, t});
  }
}

void Refiner::cut_in_two(Triangle t, int halved_side) {
  const auto side = [&](int k) { return old_.edges(t)[static_cast<std::size_t>(k % 3)]; };
  const SignedEdge ab = side(halved_side);
  const SignedEdge bc = side(halved_side + 1);
  const SignedEdge ca = side(halved_side + 2);
  const std::array<Vec3, 3> p = old_.points(t);
  const auto point = [&](int k) { return p[static_cast<std::size_t>(k % 3)]; };
  const Vec3 to_c = point(halved_side + 2) - 0.5 * (point(halved_side) + point(halved_side + 1));
  const Edge cut = add_inner(middle(ab), old_.head(bc), t, to_c);
  kept_.push_back({{tail_half(ab), SignedEdge(cut, false), ca}, t});
  added_.push_back({{head_half(ab), bc, SignedEdge(cut, true)}, t});
}

// Writes the new rows, then lets the columns inherit, then restores the order around borders.
void Refiner::write() {
  const std::uint32_t old_vertices = old_.vertex_rows();
  const std::uint32_t old_edges = old_.edge_rows();
  Film made;
  made.reserve(positions_.size(), edge_ends_.size(), kept_.size() + added_.size());
  for (const Vec3& p : positions_) made.add_vertex(p);
  for (const auto& ends : edge_ends_) made.add_edge(ends[0], ends[1]);
  for (const auto* parts : {&kept_, &added_}) {
    for (const Part& part : *parts) made.add_triangle(part.edges, old_.regions(part.whole));
  }
  film_.take_complex(std::move(made));

  std::uint32_t at = old_vertices;
  for (std::uint32_t i = 0; i < old_edges; ++i) {
    if (!halved_[i].done()) continue;
    film_.inherit(Vertex(at++), old_.ends(Edge(i))[0], old_.ends(Edge(i))[1], Edge(i));
    film_.inherit(halved_[i].head_half, Edge(i));
  }
  for (std::uint32_t i = 0; i < inside_.size(); ++i)
    film_.inherit(Edge(old_edges + counts_.edges + i), inside_[i]);
  for (std::uint32_t i = 0; i < added_.size(); ++i) {
    film_.inherit(Triangle(static_cast<std::uint32_t>(kept_.size()) + i), added_[i].whole);
  }
  if (film_.periodic()) wrap_edges();
  film_.sort_all_sides();
  begin_rings();
}

// Puts the side that walks the edge forward, or backward, first around an edge inside a film.
void begin_ring(Film& film, Edge edge, bool backward) {
  const Side first = film.first_side(edge);
  if (!first.valid() || film.edge_of(first).reversed() == backward) return;
  const Side second = film.next_around(first);
  if (film.edge_of(second).reversed() == backward) film::begin_ring(film, second);
}

// Which side is first is as in the elder program, as the directions of flipped edges depend on it: a tail
// half begins as its edge did, a head half on the other side, a new edge in a facet on the side that walks
// it.
void Refiner::begin_rings() {
  const std::uint32_t old_edges = old_.edge_rows();
  for (std::uint32_t i = 0; i < old_edges; ++i) {
    const Side first = old_.first_side(Edge(i));
    if (!first.valid()) continue;
    const bool backward = old_.edge_of(first).reversed();
    begin_ring(film_, Edge(i), backward);
    if (halved_[i].done()) begin_ring(film_, halved_[i].head_half, !backward);
  }
  for (std::uint32_t i = 0; i < inside_.size(); ++i)
    begin_ring(film_, Edge(old_edges + counts_.edges + i), false);
}

void Refiner::wrap_edges() {
  const std::uint32_t old_edges = old_.edge_rows();
  for (std::uint32_t i = 0; i < old_edges; ++i) {
    if (!halved_[i].done()) continue;
    const Vec3 half = 0.5 * old_.vector(Edge(i));
    film_.aim(SignedEdge(Edge(i), false), half);
    film_.aim(SignedEdge(halved_[i].head_half, false), half);
  }
  for (std::uint32_t i = 0; i < along_.size(); ++i)
    film_.aim(SignedEdge(Edge(old_edges + counts_.edges + i), false), along_[i]);
}

}  // namespace

RefineCounts refine(film::Film& film) {
  return Refiner(film, {}).run();
}

RefineCounts refine(film::Film& film, std::span<const std::uint8_t> halve) {
  return Refiner(film, halve).run();
}

}  // namespace lamella::surgery
