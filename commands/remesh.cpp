#include "surgery/remesh.h"

#include <cmath>

#include "session/field_values.h"
#include "session/mesh_commands.h"
#include "surgery/sizing.h"

namespace lamella::session::commands {

namespace {

// Sizes for curvature stay within this of the mean edge length.
constexpr double most_factor = 8;
constexpr double most_facets = 1e8;

struct RemeshOptions {
  std::optional<Field> size;
  std::optional<double> curvature;
  std::optional<double> borders;
  std::optional<double> points;
  long rounds = 10;
};

double mean_length(const film::Film& film) {
  double sum = 0;
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e)
    sum += length(film.vector(film::SignedEdge(film::Edge(e), false)));
  return film.edge_count() > 0 ? sum / film.edge_count() : 0;
}

// The size asked for at each vertex; that of an edge or facet is one for its vertices, the smallest counts.
std::vector<double> sizes_by_formula(Session& session, const Field& formula) {
  const film::Film& film = session.scene().film;
  const std::vector<double> values = values_of(session, formula);
  if (formula.kind == language::ElementKind::vertex) return values;
  std::vector<double> sizes(film.vertex_rows(), HUGE_VAL);
  for (std::uint32_t row = 0; row < values.size(); ++row) {
    const auto take = [&](film::Vertex v) { sizes[v.index] = std::min(sizes[v.index], values[row]); };
    if (formula.kind == language::ElementKind::edge && film.alive(film::Edge(row)))
      for (const film::Vertex v : film.ends(film::Edge(row))) take(v);
    if (formula.kind == language::ElementKind::facet && film.alive(film::Triangle(row)))
      for (const film::Vertex v : film.corners(film::Triangle(row))) take(v);
  }
  return sizes;
}

void check_sizes(const film::Film& film, std::span<const double> sizes) {
  for (std::uint32_t row = 0; row < sizes.size(); ++row) {
    const film::Vertex v(row);
    if (!film.alive(v) || !film.first_end(v).valid() || (sizes[row] > 0 && std::isfinite(sizes[row])))
      continue;
    throw text::Error(
        fmt::format("edges cannot be {:.6g} long, as is wanted at vertex {}", sizes[row], film.number(v)),
        "sizes are positive numbers");
  }
}

// By equilateral facets. Throws where there would be no end of them.
void check_facets(const film::Film& film) {
  double facets = 0;
  for (std::uint32_t row = 0; row < film.triangle_rows(); ++row) {
    if (!film.alive(film::Triangle(row))) continue;
    const auto [a, b, c] = film.points(film::Triangle(row));
    double size = 0;
    for (const film::Vertex v : film.corners(film::Triangle(row))) size += surgery::size_of(film, v) / 3;
    facets += length(cross(b - a, c - a)) / 2 / (std::sqrt(3) / 4 * size * size);
  }
  if (facets > most_facets)
    throw text::Error(fmt::format("that would make some {:.0e} facets", facets), "choose longer edges");
}

int borders_at(const film::Film& film, film::Vertex v) {
  int count = 0;
  film.for_each_end(v, [&](film::EdgeEnd end) { count += film.valence(end.edge()) >= 3 ? 1 : 0; });
  return count;
}

// The smallest of what was asked for, or what each vertex has.
void choose_sizes(Session& session, const RemeshOptions& options) {
  film::Film& film = session.scene().film;
  const bool finer_somewhere = options.curvature || options.borders || options.points;
  if (!options.size && !finer_somewhere) {
    surgery::keep_sizes(film);
    return;
  }
  const double mean = mean_length(film);
  std::vector<double> sizes(film.vertex_rows());
  if (options.size) {
    sizes = sizes_by_formula(session, *options.size);
    check_sizes(film, sizes);
  }
  const double turn = options.curvature.value_or(0) * M_PI / 180;
  const auto size_at = [&](film::Vertex v) {
    double size = options.size ? sizes[v.index] : options.curvature ? mean : surgery::size_of(film, v);
    if (options.curvature)
      size = std::min(size, std::max(surgery::size_for_curvature(film, v, turn), size / most_factor));
    const int borders = options.borders || options.points ? borders_at(film, v) : 0;
    if (options.borders && borders > 0) size = std::min(size, *options.borders);
    if (options.points && borders > 2) size = std::min(size, *options.points);
    return size;
  };
  surgery::set_sizes(film, size_at, 0, HUGE_VAL);
  check_facets(film);
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
    choose_sizes(session, options);
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
    {option("size", &RemeshOptions::size,
            "length of edges, a number or a formula; as they are around each vertex, unless given")
         .of(language::ElementKind::vertex),
     option("curvature", &RemeshOptions::curvature,
            "smaller where the film curves, so that it turns by so many degrees from facet to facet")
         .above(0),
     option("borders", &RemeshOptions::borders, "at most so long where three films or more meet").above(0),
     option("points", &RemeshOptions::points, "at most so long where borders meet").above(0),
     option("rounds", &RemeshOptions::rounds, "at most; ends early when nothing is left to do").at_least(1)},
    run);

}  // namespace lamella::session::commands
