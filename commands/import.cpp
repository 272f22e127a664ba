#include "exchange/import.h"

#include "session/session.h"
#include "session/show_filter.h"
#include "session/switches.h"

namespace lamella::session::commands {

namespace {

struct ImportWords {
  File file;
  std::optional<double> tolerance;
  std::optional<File> labels;
  bool free = false;
};

// What there is to know of how the mesh became a film.
void tell(Session& session, const exchange::Imported& imported, const std::string& path) {
  const film::Film& film = session.scene().film;
  session.tell("{}: {} vertices, {} edges, {} facets, {} bodies{}\n", path, film.vertex_count(),
               film.edge_count(), film.triangle_count(), scene::body_count(session.scene()),
               imported.found_regions ? " found from the geometry" : "");
  if (imported.merged_points > 0)
    session.tell("{} points lay within {:.3g} of others and became one with them\n", imported.merged_points,
                 imported.tolerance);
  if (imported.dropped > 0) session.tell("{} facets without area are left out\n", imported.dropped);
  if (imported.duplicates > 0) session.tell("{} facets lay upon others\n", imported.duplicates);
  if (imported.fixed_edges > 0) session.tell("{} edges of wires and rims are fixed\n", imported.fixed_edges);
  for (const std::string& warning : imported.warnings) session.warn(warning);
}

void run(Session& session, const ImportWords& words) {
  exchange::ImportOptions options{words.tolerance, {}, words.free};
  if (words.labels) options.labels = words.labels->path;
  exchange::Imported imported;
  try {
    imported = exchange::import_scene(words.file.path, options);
  } catch (const text::Error& error) {
    throw error.placed_at(words.file.place);
  }
  imported.scene.variables.restart_like(session.scene().variables);
  session.scene() = imported.scene;
  show_only(session, {});
  reset_switches(session);
  tell(session, imported, words.file.path);
}

}  // namespace

extern const Command import_command = make_command<ImportWords>(
    {.name = "import",
     .summary = "replace the scene by a mesh from another program",
     .group = CommandGroup::scene},
    {positional("file", &ImportWords::file, "an .obj, .ply, .stl or .off file").required(),
     option("tolerance", &ImportWords::tolerance,
            "points this near are one; a millionth of the diagonal unless given")
         .at_least(0),
     option("labels", &ImportWords::labels, "a file of two regions for each facet, front and back"),
     flag("free", &ImportWords::free, "rims move; fixed as if on wires unless given")},
    run);

}  // namespace lamella::session::commands
