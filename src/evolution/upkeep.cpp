#include "evolution/upkeep.h"

#include <algorithm>
#include <cmath>

#include "energy/film_energy.h"
#include "evolution/balance.h"
#include "evolution/changed_mesh.h"
#include "evolution/masses.h"
#include "evolution/rigid_velocity.h"
#include "surgery/average.h"
#include "surgery/equiangulate.h"

namespace lamella::evolution {

namespace {

constexpr int most_flip_passes = 5;
constexpr int rounds = 3;  // of flips and averaging
constexpr int rings = 2;   // around vertices that are too stiff
// The kinetic energy pays for, or takes, what the new mesh's potential energy differs by, up to this factor
// of velocities.
constexpr double most_scaling = 1.2;

// Velocities where vertices have gone by `moves`: each is a mean over the neighbours that lie ahead, exact
// for velocities that are linear along the move.
std::vector<Vec3> carried_along(const film::Film& film, std::span<const Vec3> before,
                                std::span<const Vec3> moves, const std::vector<Vec3>& velocities) {
  std::vector<double> scale(before.size());
  std::vector<Vec3> change(before.size());
  const auto visit = [&](std::uint32_t from, std::uint32_t to, const Vec3& way) {
    const double weight = std::max(0.0, dot(way, moves[from]));
    scale[from] += weight * weight;
    change[from] += weight * (velocities[to] - velocities[from]);
  };
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    const auto& [tail, head] = film.ends(film::Edge(e));
    Vec3 way = before[head.index] - before[tail.index];
    if (film.periodic()) way += film.lattice()->shift(film.wrap({film::Edge(e), false}));
    visit(tail.index, head.index, way);
    visit(head.index, tail.index, -way);
  }
  std::vector<Vec3> result = velocities;
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (scale[v] > 0) result[v] += (squared_length(moves[v]) / scale[v]) * change[v];
  }
  return result;
}

// Masses by the present areas where the mesh was changed, of the same total there; as they were elsewhere.
std::vector<double> masses_after(const scene::Scene& scene, const std::vector<std::uint8_t>& chosen) {
  energy::FilmEnergy terms(scene);
  terms.gradient(scene.film.positions());
  const std::span<const double> before = scene.film.columns(film::ElementKind::vertex).reals("mass");
  std::vector<double> masses(before.begin(), before.end());
  double area = 0;
  double mass = 0;
  for (std::size_t v = 0; v < masses.size(); ++v) {
    if (chosen[v] == 0) continue;
    area += terms.lines()[v].area;
    mass += masses[v];
  }
  for (std::size_t v = 0; v < masses.size(); ++v) {
    if (chosen[v] != 0) masses[v] = area > 0 ? terms.lines()[v].area * (mass / area) : 0;
  }
  return masses;
}

// The vertices that are too stiff, and those near them.
std::vector<std::uint8_t> stiff_places(const scene::Scene& scene, double limit) {
  energy::FilmEnergy terms(scene);
  terms.gradient(scene.film.positions());
  const std::span<const double> masses = scene.film.columns(film::ElementKind::vertex).reals("mass");
  std::vector<std::uint8_t> chosen(scene.film.vertex_rows());
  for (std::size_t v = 0; v < chosen.size(); ++v)
    chosen[v] = masses[v] > 0 && terms.lines()[v].stiffness > limit * masses[v] ? 1 : 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<std::uint8_t> inner = chosen;
    for (const auto& corners : scene.film.connectivity().triangle_vertices) {
      const bool touched =
          std::any_of(corners.begin(), corners.end(), [&](film::Vertex v) { return inner[v.index] != 0; });
      if (!touched) continue;
      for (const film::Vertex v : corners) chosen[v.index] = 1;
    }
  }
  return chosen;
}

int flip_there(film::Film& film, const std::vector<std::uint8_t>& chosen) {
  int flips = 0;
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    const film::Edge edge(e);
    const bool there =
        film.alive(edge) && chosen[film.ends(edge)[0].index] != 0 && chosen[film.ends(edge)[1].index] != 0;
    if (there && surgery::equiangulate(film, edge)) ++flips;
  }
  return flips;
}

// Momenta and energy as before; `change` is what the potential energy rose by.
void restore_motion(std::span<const Vec3> x, std::span<const double> masses, const Balance& before,
                    double change, Kept kept, std::vector<Vec3>& speeds) {
  if (!(before.mass > 0)) return;
  const Balance now = balance(x, speeds, masses);
  RigidVelocity wanted;
  RigidVelocity found;
  if (kept != Kept::none) {
    Balance moved = before;
    moved.mass = now.mass;
    wanted = rigid_velocity(moved, x, masses, kept);
    found = rigid_velocity(now, x, masses, kept);
  }
  double rigid = 0;
  double rest = 0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    speeds[v] -= found.at(x[v]);
    rest += 0.5 * masses[v] * squared_length(speeds[v]);
    rigid += 0.5 * masses[v] * squared_length(wanted.at(x[v]));
  }
  const double squared = rest > 0 ? (before.kinetic - change - rigid) / rest : 1;
  const bool payable = squared < most_scaling * most_scaling && squared * most_scaling * most_scaling > 1;
  const double factor = payable ? std::sqrt(squared) : 1;
  for (std::size_t v = 0; v < x.size(); ++v) speeds[v] = wanted.at(x[v]) + factor * speeds[v];
}

}  // namespace

bool keep_mesh_in_motion(scene::Scene& scene, double limit) {
  film::Film& film = scene.film;
  const Balance before = balance(scene);
  const double energy = potential_energy(scene);
  const std::vector<std::uint8_t> chosen = stiff_places(scene, limit);
  film.begin_rings_alike();
  std::vector<Vec3> speeds = velocities(film);
  std::vector<Vec3> moves(speeds.size());
  for (int round = 0; round < rounds; ++round) {
    for (int pass = 0; pass < most_flip_passes; ++pass) {
      if (flip_there(film, chosen) == 0) break;
    }
    const std::vector<Vec3> old(film.positions().begin(), film.positions().end());
    surgery::average_vertices(film);
    for (std::size_t v = 0; v < old.size(); ++v) {
      if (chosen[v] == 0) film.edit_positions()[v] = old[v];
      moves[v] = film.positions()[v] - old[v];
    }
    speeds = carried_along(film, old, moves, speeds);
  }
  if (!restore_volumes(scene)) return false;
  const std::vector<double> masses = masses_after(scene, chosen);
  restore_motion(film.positions(), masses, before, potential_energy(scene) - energy, kept_by(scene), speeds);
  store_motion(film, masses, speeds);
  return true;
}

}  // namespace lamella::evolution
