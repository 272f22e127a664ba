#include "picture/show.h"
#include "session/hessian_words.h"
#include "solve/modes.h"

namespace lamella::session::commands {

namespace {

struct EigenOptions {
  std::optional<long> count;
  std::optional<long> show;
  std::optional<File> file;
};

constexpr long usual_count = 6;
// In a picture the mode moves no vertex by more than this part of the film's size.
constexpr double shown_part = 0.15;

// Draws the film as the mode would have it.
void show(Session& session, HessianWork& work, const solve::Mode& mode, const std::string& path) {
  scene::Scene moved = session.scene();
  const std::span<film::Vec3> x = moved.film.edit_positions();
  std::vector<film::Vec3> way(x.size());
  work.system().basis().expand(mode.reduced, way);
  double farthest = 0;
  for (const film::Vec3& w : way) farthest = std::max(farthest, length(w));
  const double scale = shown_part / std::sqrt(work.system().scale()) / std::max(farthest, 1e-300);
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += scale * way[v];
  picture::show_file(moved, path, {});
  session.tell("picture in {}\n", path);
}

void run(Session& session, const EigenOptions& options) {
  HessianWork work(session);
  work.linearise();
  const long count =
      std::max(options.count.value_or(options.show.value_or(usual_count)), options.show.value_or(1));
  const std::vector<solve::Mode> modes =
      solve::lowest_modes(work.system(), static_cast<int>(count), session.monitor());
  if (session.monitor().stop_requested()) return;
  if (modes.empty())
    throw text::Error("the Hessian has no modes that could be found", "nothing may be free to move");
  for (std::size_t i = 0; i < modes.size(); ++i) {
    session.print("{:3}. {:18.12g}{}\n", i + 1, modes[i].value,
                  modes[i].rigid_part > 0.5 ? "  motion of the film as a whole" : "");
  }
  session.counter("last_eigenvalue") = modes.front().value;
  if (!options.show) return;
  const auto which = static_cast<std::size_t>(*options.show);
  if (which > modes.size())
    throw text::Error(fmt::format("there is no mode {}", which),
                      fmt::format("the film has {}", modes.size()));
  const std::string path = options.file ? options.file->path : fmt::format("eigen_{}.png", which);
  show(session, work, modes[which - 1], path);
}

}  // namespace

extern const Command eigen_command = make_command<EigenOptions>(
    {.name = "eigen",
     .summary = "the lowest modes of the Hessian, volumes kept",
     .group = CommandGroup::measure},
    {positional("count", &EigenOptions::count, "how many; 6 unless given").at_least(1).at_most(500),
     option("show", &EigenOptions::show, "number of a mode to draw").at_least(1).at_most(500),
     positional("file", &EigenOptions::file, "its picture; eigen_NUMBER.png unless given")},
    run);

}  // namespace lamella::session::commands
