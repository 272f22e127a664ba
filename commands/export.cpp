#include "exchange/export.h"

#include "session/field_values.h"
#include "session/picture_words.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ExportWords : PictureWords {
  File file;
  std::string per = "scene";
  std::optional<Field> values;
};

// The scene with the values of a formula as one column more.
scene::Scene with_values(Session& session, const Field& field) {
  scene::Scene scene = session.scene();
  if (field.kind == language::ElementKind::edge)
    throw text::Error("values are of facets or vertices, not of edges", "as in values=vertex mean_curvature");
  film::Column column = film::real_column("values");
  column.data = values_of(session, field);
  scene.film
      .columns(field.kind == language::ElementKind::vertex ? film::ElementKind::vertex
                                                           : film::ElementKind::facet)
      .add(std::move(column));
  return scene;
}

void run(Session& session, const ExportWords& words) {
  if (session.scene().empty())
    throw text::Error("there is nothing to export", "load a datafile first: load cube.fe");
  exchange::ExportOptions options;
  if (words.per == "body") options.per = exchange::Division::body;
  options.picture = picture_options(session, words);
  try {
    const exchange::Exported exported = exchange::export_scene(
        words.values ? with_values(session, *words.values) : session.scene(), words.file.path, options);
    exchange::write_files(exported.files);
    for (const std::string& warning : exported.warnings) session.warn(warning);
    for (const exchange::NamedFile& file : exported.files) session.tell("{}\n", file.path);
  } catch (const text::Error& error) {
    throw error.placed_at(words.file.place);
  }
}

std::vector<ArgumentOf<ExportWords>> arguments() {
  std::vector<ArgumentOf<ExportWords>> table = {
      positional("file", &ExportWords::file,
                 "its ending is the format: vtp, vtu, ply, obj, stl, glb, xml, fe")
          .required(),
      option("per", &ExportWords::per, "one file for all, or one for each body").one_of({"scene", "body"}),
      option("values", &ExportWords::values, "a formula of facets or vertices, written beside the mesh")};
  for (ArgumentOf<ExportWords>& word : picture_arguments<ExportWords>()) table.push_back(std::move(word));
  return table;
}

}  // namespace

extern const Command export_command = make_command<ExportWords>(
    {.name = "export", .summary = "write the scene for another program", .group = CommandGroup::output},
    arguments(), run);

}  // namespace lamella::session::commands
