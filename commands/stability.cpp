#include <filesystem>

#include "chart/plot.h"
#include "evolution/adapt.h"
#include "evolution/largest_step.h"
#include "evolution/levels.h"
#include "session/session.h"
#include "solve/reach_volumes.h"
#include "text/whole_file.h"

namespace lamella::session::commands {

namespace {

using evolution::Method;

struct StabilityOptions {
  std::optional<File> file;
  std::optional<std::string> methods;
  long levels = 1;
  long tensions = 1;
  double steps = 300;
};

struct Row {
  std::string method;
  std::uint32_t facets = 0;
  double tension = 1;
  evolution::LargestStep found;
};

struct Named {
  const char* name;
  Method method;
};
constexpr std::array<Named, 5> integrators = {{{"euler", Method::euler},
                                               {"verlet", Method::verlet},
                                               {"gradient", Method::gradient},
                                               {"implicit", Method::implicit},
                                               {"midpoint", Method::midpoint}}};
constexpr double tension_step = 4;

std::vector<Named> chosen(const std::optional<std::string>& list) {
  if (!list) return {integrators.begin(), integrators.end()};
  std::vector<Named> result;
  std::string name;
  for (const char c : *list + ",") {
    if (c != ',' && c != ' ') {
      name += c;
      continue;
    }
    if (name.empty()) continue;
    const auto at = std::find_if(integrators.begin(), integrators.end(),
                                 [&](const Named& each) { return name == each.name; });
    if (at == integrators.end())
      throw text::Error(fmt::format("there is no integrator \"{}\"", name),
                        "the integrators are euler, verlet, gradient, implicit, midpoint");
    result.push_back(*at);
    name.clear();
  }
  return result;
}

void scale_tension(scene::Scene& scene, double factor) {
  film::Columns& columns = scene.film.columns(film::ElementKind::facet);
  film::Column* column = columns.edit("tension");
  if (column == nullptr) column = &columns.add(film::real_column("tension", 1));
  for (double& tension : std::get<film::Reals>(column->data)) tension *= factor;
}

// Twice as fine, with its volumes.
void refine(scene::Scene& scene) {
  evolution::refine_everywhere(scene);
  if (!scene.keep_volumes || !scene.has_fixed_volume()) return;
  solve::Problem problem(scene);
  problem.hold_parameters();
  double energy = 0;
  const solve::Ending ending = solve::reach_volumes(scene, problem, scene.film.edit_positions(), energy);
  if (ending != solve::Ending::converged) throw text::Error(std::string(solve::describe(ending)));
}

std::string table(const std::vector<Row>& rows) {
  std::string text = "method,facets,tension,bound,largest,ratio,failure\n";
  for (const Row& row : rows) {
    const double largest = row.found.fraction * row.found.bound;
    text += fmt::format("{},{},{:g},{:.6g},{:.6g},{:.4f},{}\n", row.method, row.facets, row.tension,
                        row.found.bound, largest, 1 / row.found.fraction,
                        row.found.limited ? row.found.failure : "none");
  }
  return text;
}

std::string script(const std::vector<Row>& rows, const std::string& title,
                   const std::filesystem::path& picture) {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    if (std::find(names.begin(), names.end(), row.method) == names.end()) names.push_back(row.method);
  }
  std::string text =
      chart::picture_settings(picture) + "set title " + chart::quoted(title) +
      "\nset logscale xy\nset xlabel 'predicted bound'\nset ylabel 'largest step that survives'\n"
      "set key outside right\nset grid\nplot x with lines title 'equal'";
  for (const std::string& name : names)
    text += ", '-' using 1:2 with points pointtype 7 title " + chart::quoted(name);
  text += "\n";
  for (const std::string& name : names) {
    for (const Row& row : rows) {
      if (row.method == name)
        text += fmt::format("{:.6g} {:.6g}\n", row.found.bound, row.found.fraction * row.found.bound);
    }
    text += "e\n";
  }
  return text;
}

void run(Session& session, const StabilityOptions& options) {
  if (session.scene().empty())
    throw text::Error("there is no film to try steps on", "load a datafile first: load \"cube.fe\"");
  const std::optional<std::filesystem::path> picture =
      options.file ? std::optional<std::filesystem::path>(options.file->path) : std::nullopt;
  if (picture && picture->extension() != ".svg" && picture->extension() != ".png")
    throw text::Error(fmt::format("a chart is an .svg or .png file, not \"{}\"", picture->string()));
  const std::vector<Named> methods = chosen(options.methods);
  evolution::Trials trials;
  trials.steps = options.steps;
  std::vector<Row> rows;
  session.print("{:9} {:>8} {:>8} {:>11} {:>11} {:>15}  {}\n", "method", "facets", "tension", "bound",
                "largest", "bound/largest", "above it");
  scene::Scene level = session.scene();
  for (long n = 0; n < options.levels; ++n) {
    if (n > 0) refine(level);
    scene::Scene tense = level;
    for (long k = 0; k < options.tensions; ++k) {
      if (k > 0) scale_tension(tense, tension_step);
      for (const Named& each : methods) {
        Row row{each.name, tense.film.triangle_count(), std::pow(tension_step, static_cast<double>(k)),
                evolution::find_largest_step(tense, each.method, trials, session.monitor())};
        if (session.monitor().stop_requested()) return;
        if (!(row.found.fraction > 0))
          throw text::Error("no step survives",
                            row.found.failure.empty() ? "nothing in the scene can move" : row.found.failure);
        session.print(
            "{:9} {:8} {:8g} {:11.5g} {:>11} {:15.3f}  {}\n", row.method, row.facets, row.tension,
            row.found.bound,
            fmt::format("{}{:.5g}", row.found.limited ? "" : ">", row.found.fraction * row.found.bound),
            1 / row.found.fraction, row.found.limited ? row.found.failure : "it survives");
        rows.push_back(std::move(row));
      }
    }
  }
  if (!picture) return;
  text::write_whole_file(std::filesystem::path(*picture).replace_extension(".csv").string(), table(rows));
  const std::string name = std::filesystem::path(session.scene().name).filename().string();
  chart::run_gnuplot(script(rows, name, *picture), *picture);
}

}  // namespace

extern const Command stability_command = make_command<StabilityOptions>(
    {.name = "stability",
     .summary = "find the largest step that each integrator survives",
     .group = CommandGroup::measure},
    {positional("file", &StabilityOptions::file, "a chart, .svg or .png, with its numbers in .csv beside it"),
     option("methods", &StabilityOptions::methods, "names separated by commas, in quotes; all unless given"),
     option("levels", &StabilityOptions::levels,
            "the scene, and so many less one refinements of it; 1 unless given")
         .at_least(1)
         .at_most(8),
     option("tensions", &StabilityOptions::tensions,
            "its tension, and so many less one of four times the last")
         .at_least(1)
         .at_most(8),
     option("steps", &StabilityOptions::steps, "of the predicted bound to be survived; 300 unless given")
         .above(0)},
    run);

}  // namespace lamella::session::commands
