#include "chart/evolver.h"
#include "chart/plot.h"
#include "session/session.h"
#include "text/whole_file.h"

namespace lamella::session::commands {

namespace {

struct ChartOptions {
  std::optional<File> file;
  std::optional<std::string> methods;
  long levels = 4;
  std::optional<double> exact;
  double limit = 20;
};

std::vector<std::string> known_methods() {
  std::vector<std::string> names = chart::own_methods();
  names.insert(names.end(), chart::evolver_modes().begin(), chart::evolver_modes().end());
  return names;
}

std::vector<std::string> chosen_methods(const std::optional<std::string>& list) {
  const std::vector<std::string> known = known_methods();
  std::vector<std::string> chosen;
  if (!list) {
    chosen = chart::own_methods();
    if (chart::evolver_installed())
      chosen.insert(chosen.end(), chart::evolver_modes().begin(), chart::evolver_modes().end());
    return chosen;
  }
  std::string name;
  for (const char c : *list + ",") {
    if (c != ',' && c != ' ') {
      name += c;
    } else if (!name.empty()) {
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw text::Error(fmt::format("there is no method \"{}\"", name),
                          fmt::format("the methods are {}", fmt::join(known, ", ")));
      chosen.push_back(std::exchange(name, {}));
    }
  }
  return chosen;
}

chart::Curve run_one(Session& session, const std::string& method, const chart::RaceOptions& race,
                     std::optional<evolution::Extrapolation>& limit) {
  const auto& modes = chart::evolver_modes();
  if (std::find(modes.begin(), modes.end(), method) != modes.end())
    return chart::run_evolver(method, session.scene(), race);
  return chart::run_own(method, session.scene(), race, session.monitor(),
                        method == "relax" ? &limit : nullptr);
}

// Against the exact value, or what the levels of relax tend to.
double reference_of(Session& session, const ChartOptions& options, const chart::RaceOptions& race,
                    std::optional<evolution::Extrapolation> limit) {
  if (options.exact) return *options.exact;
  if (!limit) chart::run_own("relax", session.scene(), race, session.monitor(), &limit);
  if (!limit) throw text::Error("too few levels to extrapolate from", "give more levels, or exact=VALUE");
  return limit->energy;
}

void run(Session& session, const ChartOptions& options) {
  if (session.scene().empty())
    throw text::Error("there is no film to race on", "load a datafile first: load \"cube.fe\"");
  const std::filesystem::path picture = options.file ? options.file->path : "chart.svg";
  if (picture.extension() != ".svg" && picture.extension() != ".png")
    throw text::Error(fmt::format("a chart is an .svg or .png file, not \"{}\"", picture.string()));
  const chart::RaceOptions race{options.levels, options.limit};
  std::vector<chart::Curve> curves;
  std::optional<evolution::Extrapolation> limit;
  for (const std::string& method : chosen_methods(options.methods)) {
    curves.push_back(run_one(session, method, race, limit));
    if (session.monitor().stop_requested()) return;
  }
  const double reference = reference_of(session, options, race, limit);
  session.tell("{:17} {:>10} {:>10} {:>20} {:>10}\n", "method", "seconds", "facets", "energy", "error");
  for (const chart::Curve& curve : curves) {
    if (curve.samples.empty()) continue;
    const chart::Sample& last = curve.samples.back();
    session.tell("{:17} {:10.4g} {:10} {:20.12f} {:10.2g}\n", curve.method, last.seconds, last.facets,
                 last.energy, std::abs(last.energy / reference - 1));
  }
  text::write_whole_file(std::filesystem::path(picture).replace_extension(".csv").string(),
                         chart::table(curves, reference));
  const std::string name = std::filesystem::path(session.scene().name).filename().string();
  chart::plot(curves, reference, fmt::format("{}, relative to {:.10g}", name, reference), picture);
}

}  // namespace

extern const Command chart_command = make_command<ChartOptions>(
    {.name = "chart",
     .summary = "race methods on the scene and draw error against time",
     .group = CommandGroup::measure},
    {positional("file", &ChartOptions::file, "the picture, .svg or .png; chart.svg unless given"),
     option("methods", &ChartOptions::methods, "names separated by commas, in quotes; all unless given"),
     option("levels", &ChartOptions::levels, "refinements, from coarse to fine").at_least(0).at_most(12),
     option("exact", &ChartOptions::exact, "the energy to measure errors against"),
     option("limit", &ChartOptions::limit, "processor seconds for each method").above(0)},
    run);

}  // namespace lamella::session::commands
