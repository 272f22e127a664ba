#include "scene/constraint_sets.h"
#include "session/session.h"
#include "solve/problem.h"
#include "surgery/smooth.h"

namespace lamella::session::commands {

namespace {

struct AverageOptions {
  std::optional<Elements> vertices;
  long times = 1;
};

// Averaging keeps volumes to first order; the rest is made good. Volumes go back to what they were, which
// need not be their targets yet.
void restore_volumes(scene::Scene& scene, const energy::Measures& before) {
  scene::Scene held = scene;
  for (std::size_t b = 0; b < held.bodies.size(); ++b) {
    if (held.bodies[b].fixed_volume()) held.bodies[b].target_volume = before.volumes[b + 1];
  }
  solve::Problem problem(held);
  problem.hold_parameters();
  double energy = 0;
  if (problem.linearise_and_restore(scene.film.edit_positions(), energy) != solve::Ending::converged) {
    throw text::Error("the volumes were lost in averaging",
                      "the mesh may be too coarse or tangled: try check, u or refine");
  }
}

// One vertex after the other, each from where those before it have gone.
void average_some(Session& session, const Elements& vertices) {
  if (vertices.kind != language::ElementKind::vertex)
    throw text::Error("only vertices can be averaged", "vertex_average vertices where valence > 6");
  for (const language::Element& vertex : vertices.list) {
    film::Film& film = session.scene().film;
    const film::Vertex v(vertex.row);
    film.move(v, film.position(v) + surgery::averaging_move(film, v, surgery::Averaging::keep_volume));
  }
}

void run(Session& session, const AverageOptions& options) {
  scene::Scene& scene = session.scene();
  if (scene.empty())
    throw text::Error("there is no film to average", "load a datafile first: load \"cube.fe\"");
  const energy::Measures before = session.measures();
  for (long i = 0; i < options.times && !session.monitor().stop_requested(); ++i) {
    if (options.vertices) {
      average_some(session, *options.vertices);
    } else {
      surgery::smooth_vertices(scene.film, surgery::Averaging::keep_volume);
    }
    scene::constrain_vertices(scene);
    if (scene.keep_volumes && scene.has_fixed_volume()) restore_volumes(scene, before);
    if (!options.vertices) session.tell("Vertex averaging done.\n");
  }
}

}  // namespace

extern const Command average_command =
    make_command<AverageOptions>({.name = "average",
                                  .aliases = {"V", "vertex_average"},
                                  .summary = "move vertices to the middle of their neighbours, volumes kept",
                                  .group = CommandGroup::mesh},
                                 {positional("vertices", &AverageOptions::vertices, "only these, in turn"),
                                  positional("times", &AverageOptions::times, "how often").at_least(0)},
                                 run);

}  // namespace lamella::session::commands
