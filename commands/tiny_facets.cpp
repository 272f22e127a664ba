#include "energy/triangle.h"
#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

struct TinyFacetsOptions {
  double area = 0;
};

void run(Session& session, const TinyFacetsOptions& options) {
  check_film(session, "to weed");
  scene::Scene& scene = session.scene();
  const film::Film& film = scene.film;
  long collapsed = 0;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const film::Triangle t(i);
    if (!film.alive(t)) continue;
    const std::array<film::Vec3, 3> p = film.points(t);
    const double area = energy::triangle_area(p[0], p[1], p[2]);
    if (area >= options.area) continue;
    if (surgery::collapse_facet(scene, t) == surgery::Collapse::done) ++collapsed;
    if (session.monitor().stop_requested()) break;
  }
  finish_surgery(session);
  session.counter("facet_delete_count") = static_cast<double>(collapsed);
  session.tell("Skinny triangles weeded: {}\n", collapsed);
}

}  // namespace

extern const Command tiny_facets_command = make_command<TinyFacetsOptions>(
    {.name = "tiny_facets",
     .aliases = {"w", "areaweed"},
     .summary = "collapse facets smaller than an area",
     .group = CommandGroup::mesh},
    {positional("area", &TinyFacetsOptions::area, "facets smaller than this collapse")
         .required()
         .at_least(0)},
    run);

}  // namespace lamella::session::commands
