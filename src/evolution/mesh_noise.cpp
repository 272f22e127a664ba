#include "evolution/mesh_noise.h"

#include <algorithm>
#include <cmath>

#include "evolution/balance.h"
#include "evolution/masses.h"
#include "evolution/rigid_velocity.h"
#include "film/union_find.h"
#include "scene/constraint_sets.h"

namespace lamella::evolution {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Side;
using film::Vertex;
using scene::Scene;

namespace {

// Energy is given back by no more than this factor of velocities.
constexpr double most_factor = 1.1;

// How many films are around an edge; more than three are as good as three.
int films_around(const Film& film, Edge e) {
  const Side first = film.first_side(e);
  if (!first.valid()) return 0;
  const Side second = film.next_around(first);
  if (second == first) return 1;
  return film.next_around(second) == first ? 2 : 3;
}

std::vector<std::uint8_t> held_vertices(const Scene& scene) {
  std::vector<std::uint8_t> held(scene.film.vertex_rows());
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  std::copy(fixed.begin(), fixed.end(), held.begin());
  if (scene.level_sets.empty() && scene.boundaries.empty()) return held;
  for (std::uint32_t v = 0; v < held.size(); ++v) {
    if (!scene::constraints_of(scene, ElementKind::vertex, v).empty() ||
        scene::boundary_of(scene, ElementKind::vertex, v) != 0)
      held[v] = 1;
  }
  return held;
}

class Damper {
 public:
  explicit Damper(Scene& scene) : scene_(scene), film_(scene.film), held_(held_vertices(scene)) {
    const auto masses = film_.columns(ElementKind::vertex).reals("mass");
    masses_.assign(masses.begin(), masses.end());
    before_ = velocities_ = velocities(film_);
  }

  void damp(double part);
  void give_back();
  void store() { store_motion(film_, masses_, velocities_); }

 private:
  double inverse_mass(Vertex v) const {
    return held_[v.index] == 0 && masses_[v.index] > 0 ? 1 / masses_[v.index] : 0;
  }
  void give_back(std::span<const std::uint32_t> vertices);

  Scene& scene_;
  Film& film_;
  std::vector<std::uint8_t> held_;
  std::vector<double> masses_;
  std::vector<Vec3> before_;
  std::vector<Vec3> velocities_;
};

void Damper::damp(double part) {
  std::vector<std::uint8_t> films(film_.edge_rows());
  std::vector<int> lines(film_.vertex_rows());  // edges that are not inside a film
  for (std::uint32_t e = 0; e < films.size(); ++e) {
    if (!film_.alive(Edge(e))) continue;
    films[e] = static_cast<std::uint8_t>(films_around(film_, Edge(e)));
    if (films[e] == 2) continue;
    for (const Vertex v : film_.ends(Edge(e))) ++lines[v.index];
  }
  for (std::uint32_t e = 0; e < films.size(); ++e) {
    if (films[e] == 0) continue;
    const auto [tail, head] = film_.ends(Edge(e));
    // Across borders, and at their ends, films move for good reasons.
    const int wanted = films[e] == 2 ? 0 : 2;
    if (lines[tail.index] != wanted || lines[head.index] != wanted) continue;
    const double at_tail = inverse_mass(tail);
    const double at_head = inverse_mass(head);
    if (at_tail + at_head <= 0) continue;
    const Vec3 way = unit(film_.vector(Edge(e)));
    const double speed = dot(velocities_[head.index] - velocities_[tail.index], way);
    const double impulse = part * speed / (at_tail + at_head);
    velocities_[tail.index] += (impulse * at_tail) * way;
    velocities_[head.index] -= (impulse * at_head) * way;
  }
}

// To each part of the film by itself: bubbles that fly are not to fly faster because others swing.
void Damper::give_back() {
  film::UnionFind parts(film_.vertex_rows());
  for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
    if (film_.alive(Edge(e))) parts.join(film_.ends(Edge(e))[0].index, film_.ends(Edge(e))[1].index);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // part, vertex
  for (std::uint32_t v = 0; v < film_.vertex_rows(); ++v) order.emplace_back(parts.find(v), v);
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> vertices;
  for (std::size_t i = 0; i < order.size(); ++i) {
    vertices.push_back(order[i].second);
    if (i + 1 < order.size() && order[i + 1].first == order[i].first) continue;
    give_back(vertices);
    vertices.clear();
  }
}

void Damper::give_back(std::span<const std::uint32_t> vertices) {
  std::vector<Vec3> x;
  std::vector<Vec3> v;
  std::vector<double> m;
  bool held = false;
  double before = 0;
  for (const std::uint32_t row : vertices) {
    x.push_back(film_.positions()[row]);
    v.push_back(velocities_[row]);
    m.push_back(masses_[row]);
    held = held || held_[row] != 0;
    before += 0.5 * masses_[row] * squared_length(before_[row]);
  }
  const Balance now = balance(x, v, m);
  if (!(now.mass > 0)) return;
  const RigidVelocity rigid = held ? RigidVelocity{} : rigid_velocity(now, x, m, Kept::both_momenta);
  double moving = 0;
  for (std::size_t i = 0; i < x.size(); ++i) moving += 0.5 * m[i] * squared_length(v[i] - rigid.at(x[i]));
  if (!(moving > 0)) return;
  const double factor = std::min(most_factor, std::sqrt(1 + std::max(0.0, before - now.kinetic) / moving));
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (held_[vertices[i]] == 0) velocities_[vertices[i]] = rigid.at(x[i]) + factor * (v[i] - rigid.at(x[i]));
  }
}

}  // namespace

void damp_mesh_noise(Scene& scene, double part, bool keeps_energy) {
  Damper damper(scene);
  damper.damp(part);
  if (keeps_energy) damper.give_back();
  damper.store();
}

}  // namespace lamella::evolution
