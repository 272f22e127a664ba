#include "evolution/upkeep.h"

#include <algorithm>
#include <cmath>

#include "evolution/balance.h"
#include "evolution/masses.h"
#include "scene/constraint_sets.h"
#include "solve/problem.h"
#include "surgery/average.h"
#include "surgery/equiangulate.h"

namespace lamella::evolution {

namespace {

constexpr int most_flip_passes = 5;
constexpr int rounds = 3;  // of flips and averaging

// Velocities where vertices have gone by `moves`: each is a mean over the neighbours that lie ahead, exact
// for velocities that are linear along the move.
std::vector<Vec3> carried_along(const film::Film& film, std::span<const Vec3> before,
                                std::span<const Vec3> moves, const std::vector<Vec3>& velocities) {
  std::vector<double> scale(before.size());
  std::vector<Vec3> change(before.size());
  const auto ahead = [&](std::uint32_t from, std::uint32_t to) {
    return std::max(0.0, dot(before[to] - before[from], moves[from]));
  };
  const auto visit = [&](std::uint32_t from, std::uint32_t to) {
    const double weight = ahead(from, to);
    scale[from] += weight * weight;
    change[from] += weight * (velocities[to] - velocities[from]);
  };
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    const auto& [tail, head] = film.ends(film::Edge(e));
    visit(tail.index, head.index);
    visit(head.index, tail.index);
  }
  std::vector<Vec3> result = velocities;
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (scale[v] > 0) result[v] += (squared_length(moves[v]) / scale[v]) * change[v];
  }
  return result;
}

bool restore_volumes(scene::Scene& scene) {
  scene::constrain_vertices(scene);
  solve::Problem problem(scene);
  bool ok = false;
  double energy = problem.linearise(scene.film.positions(), ok);
  ok = ok && problem.restore_volumes(scene.film.edit_positions(), energy) == solve::Ending::converged;
  if (ok) problem.publish(scene);
  return ok;
}

// Masses by the present areas, of the same total.
std::vector<double> spread_mass(const scene::Scene& scene, double total) {
  energy::FilmEnergy terms(scene);
  terms.gradient(scene.film.positions());
  std::vector<double> masses(scene.film.vertex_rows());
  double area = 0;
  for (const energy::VertexLine& line : terms.lines()) area += line.area;
  for (std::size_t v = 0; v < masses.size(); ++v)
    masses[v] = area > 0 ? terms.lines()[v].area * (total / area) : 0;
  return masses;
}

}  // namespace

bool keep_mesh_in_motion(scene::Scene& scene) {
  film::Film& film = scene.film;
  const Balance before = balance(scene);
  std::vector<Vec3> speeds = velocities(film);
  std::vector<Vec3> moves(speeds.size());
  for (int round = 0; round < rounds; ++round) {
    for (int pass = 0; pass < most_flip_passes; ++pass) {
      if (surgery::equiangulate(film) == 0) break;
    }
    const std::vector<Vec3> old(film.positions().begin(), film.positions().end());
    surgery::average_vertices(film);
    for (std::size_t v = 0; v < old.size(); ++v) moves[v] = film.positions()[v] - old[v];
    speeds = carried_along(film, old, moves, speeds);
  }
  if (!restore_volumes(scene)) return false;
  const std::vector<double> masses = spread_mass(scene, before.mass);
  const auto fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  const bool free = std::none_of(fixed.begin(), fixed.end(), [](auto flag) { return flag != 0; });
  if (free && before.mass > 0 && scene.level_sets.empty() && scene.boundaries.empty()) {
    const Balance now = balance(film.positions(), speeds, masses);
    for (Vec3& speed : speeds) speed += (before.momentum - now.momentum) / before.mass;
  }
  store_motion(film, masses, speeds);
  return true;
}

}  // namespace lamella::evolution
