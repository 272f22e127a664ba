#include "surgery/remesh.h"

#include <cmath>

#include "session/mesh_commands.h"
#include "surgery/sizing.h"

namespace lamella::session::commands {

namespace {

// Sizes for curvature stay within this of the mean edge length.
constexpr double most_factor = 8;

struct RemeshOptions {
  std::optional<double> size;
  std::optional<double> curvature;
  long rounds = 10;
};

double mean_length(const film::Film& film) {
  double sum = 0;
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e)
    sum += length(film.vector(film::SignedEdge(film::Edge(e), false)));
  return film.edge_count() > 0 ? sum / film.edge_count() : 0;
}

void choose_sizes(film::Film& film, const RemeshOptions& options) {
  if (options.curvature) {
    const double turn = *options.curvature * M_PI / 180;
    const double most = options.size.value_or(mean_length(film));
    surgery::set_sizes(
        film, [&](film::Vertex v) { return surgery::size_for_curvature(film, v, turn); }, most / most_factor,
        most);
  } else if (options.size) {
    surgery::set_sizes(
        film, [&](film::Vertex) { return *options.size; }, *options.size, *options.size);
  } else {
    surgery::keep_sizes(film);
  }
}

void run(Session& session, const RemeshOptions& options) {
  check_film(session, "to remesh");
  scene::Scene& scene = session.scene();
  if (scene.film.periodic())
    throw text::Error("a periodic film keeps its mesh", "refine, u and V work on it");
  surgery::RemeshOptions band;
  band.longest = 1.4;
  band.shortest = 0.7;
  band.flip_slack = 0.05;
  band.rounds = 1;
  surgery::RemeshReport sum;
  for (long round = 0; round < options.rounds && !session.monitor().stop_requested(); ++round) {
    choose_sizes(scene.film, options);
    const surgery::RemeshReport report = surgery::remesh(scene, band);
    finish_surgery(session);
    sum.splits += report.splits;
    sum.collapses += report.collapses;
    sum.flips += report.flips;
    if (report.operations() == 0) break;
  }
  session.tell("edges divided: {}  collapsed: {}  flipped: {}\n", sum.splits, sum.collapses, sum.flips);
}

}  // namespace

extern const Command remesh_command = make_command<RemeshOptions>(
    {.name = "remesh",
     .summary = "divide long edges, collapse short ones and flip the rest, toward a size",
     .group = CommandGroup::mesh},
    {option("size", &RemeshOptions::size, "length of edges; as they are around each vertex, unless given")
         .above(0),
     option("curvature", &RemeshOptions::curvature,
            "smaller where the film curves, so that it turns by so many degrees from facet to facet")
         .above(0),
     option("rounds", &RemeshOptions::rounds, "at most; ends early when nothing is left to do").at_least(1)},
    run);

}  // namespace lamella::session::commands
