#include <cmath>
#include <random>

#include "evolution/masses.h"
#include "language/formula.h"
#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

using film::Vec3;

struct KickOptions {
  std::optional<VertexFormulas> formulas;
  std::optional<double> random;
  std::optional<long> seed;
  std::optional<long> body;
  bool off = false;
};

// Which vertices are meant: all, or those on the films of a body.
std::vector<bool> vertices_meant(const scene::Scene& scene, const std::optional<long>& body) {
  std::vector<bool> meant(scene.film.vertex_rows(), !body);
  if (!body) return meant;
  const auto number = static_cast<std::uint32_t>(*body);
  if (number > scene.bodies.size() || scene.bodies[number - 1].absent)
    throw text::Error(fmt::format("there is no body {}", *body));
  const film::Connectivity& complex = scene.film.connectivity();
  for (std::size_t t = 0; t < complex.triangle_vertices.size(); ++t) {
    const film::RegionPair pair = complex.triangle_regions[t];
    if (pair.front.index != number && pair.behind.index != number) continue;
    for (const film::Vertex v : complex.triangle_vertices[t]) meant[v.index] = true;
  }
  return meant;
}

Vec3 value(const scene::VectorFormula& formula, const Vec3& at, const Vec3& velocity, double time) {
  const std::array<double, 3> place{at.x, at.y, at.z};
  const std::array<double, 6> state{velocity.x, velocity.y, velocity.z, 0, 0, 0};
  const language::FormulaInputs inputs{place, time, state};
  const Vec3 result{formula.component[0].value(inputs), formula.component[1].value(inputs),
                    formula.component[2].value(inputs)};
  if (std::isfinite(result.x + result.y + result.z)) return result;
  throw text::Error(fmt::format("the velocity at ({:g}, {:g}, {:g}) is not finite", at.x, at.y, at.z));
}

void run(Session& session, const KickOptions& options) {
  check_film(session, "to kick");
  scene::Scene& scene = session.scene();
  if (options.off ? options.formulas || options.random || options.seed
                  : options.formulas.has_value() == options.random.has_value())
    throw text::Error("a velocity, a random one, or off?",
                      "kick (0, 0, 0.1), or kick random 0.1 seed 1, or kick off");
  std::vector<Vec3> velocity = evolution::velocities(scene.film);
  const std::vector<bool> meant = vertices_meant(scene, options.body);
  std::optional<scene::VectorFormula> formula;
  if (options.formulas) {
    formula = options.formulas->formula;
    for (language::Formula& component : formula->component) component.bind(scene.variables);
  }
  std::mt19937_64 own(static_cast<std::uint64_t>(options.seed.value_or(0)));
  std::mt19937_64& numbers = options.seed ? own : session.random();
  std::normal_distribution<double> any(0, 1);
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  for (std::uint32_t v = 0; v < velocity.size(); ++v) {
    if (!meant[v] || (!fixed.empty() && fixed[v] != 0)) continue;
    if (options.off) velocity[v] = {};
    if (formula)
      velocity[v] += value(*formula, scene.film.position(film::Vertex(v)), velocity[v], scene.time);
    if (!options.random) continue;
    for (int axis = 0; axis < 3; ++axis) velocity[v][axis] += *options.random * any(numbers);
  }
  evolution::store_velocities(scene.film, velocity);
}

}  // namespace

extern const Command kick_command = make_command<KickOptions>(
    {.name = "kick",
     .summary = "give the film, or the films of a body, a velocity",
     .group = CommandGroup::motion},
    {positional("formulas", &KickOptions::formulas,
                "velocity to be added, in x, y, z, vx, vy, vz, total_time"),
     option("random", &KickOptions::random, "adds this times a normally distributed number to each component")
         .at_least(0),
     option("seed", &KickOptions::seed, "of the random numbers; random_seed goes on unless given")
         .at_least(0),
     option("body", &KickOptions::body, "only the films of this body").at_least(1),
     flag("off", &KickOptions::off, "stops the film")},
    run);

}  // namespace lamella::session::commands
