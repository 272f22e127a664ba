#include <random>

#include "scene/constraint_sets.h"
#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

struct ShakeOptions {
  std::optional<double> temperature;
};

double mean_edge_length(const film::Film& film) {
  double sum = 0;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    if (film.alive(e)) sum += length(film.vector(e));
  }
  return film.edge_count() > 0 ? sum / film.edge_count() : 0;
}

void run(Session& session, const ShakeOptions& options) {
  check_film(session, "to shake");
  scene::Scene& scene = session.scene();
  constexpr double usual = 0.05;
  double& kept = session.counter("jiggle_temperature");
  const double temperature = options.temperature.value_or(kept > 0 ? kept : usual);
  kept = temperature;
  std::normal_distribution<double> step(0, temperature * mean_edge_length(scene.film));
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  const std::span<film::Vec3> positions = scene.film.edit_positions();
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (!fixed.empty() && fixed[i] != 0) continue;
    const double x = step(session.random());
    const double y = step(session.random());
    const double z = step(session.random());
    positions[i] += film::Vec3{x, y, z};
  }
  finish_surgery(session);
  session.tell("One jiggle done.\n");
}

}  // namespace

extern const Command shake_command = make_command<ShakeOptions>(
    {.name = "shake",
     .aliases = {"j"},
     .summary = "move every vertex at random",
     .group = CommandGroup::motion},
    {positional("temperature", &ShakeOptions::temperature, "how far, in mean edge lengths; 0.05 at first")
         .at_least(0)},
    run);

}  // namespace lamella::session::commands
