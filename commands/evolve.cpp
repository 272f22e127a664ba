#include <cmath>

#include "evolution/hyperbolic.h"
#include "session/motion_log.h"
#include "session/session.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

struct EvolveOptions {
  long steps = 1;
  std::optional<double> dt;
  std::optional<std::string> method;
  std::optional<std::string> volumes;
  bool keep_mesh = false;
};

template <class Value>
using Named = std::pair<const char*, Value>;

constexpr std::array<Named<evolution::Method>, 5> methods = {{{"euler", evolution::Method::euler},
                                                              {"verlet", evolution::Method::verlet},
                                                              {"gradient", evolution::Method::gradient},
                                                              {"implicit", evolution::Method::implicit},
                                                              {"midpoint", evolution::Method::midpoint}}};

constexpr std::array<Named<evolution::VolumeMode>, 4> volume_modes = {
    {{"auto", evolution::VolumeMode::automatic},
     {"lagged", evolution::VolumeMode::lagged},
     {"exact", evolution::VolumeMode::exact},
     {"paper", evolution::VolumeMode::paper}}};

template <class Value, std::size_t n>
std::vector<std::string> names_of(const std::array<Named<Value>, n>& table) {
  std::vector<std::string> names;
  for (const auto& [name, value] : table) names.emplace_back(name);
  return names;
}

// The first where no name is given.
template <class Value, std::size_t n>
Value value_of(const std::array<Named<Value>, n>& table, const std::optional<std::string>& wanted) {
  for (const auto& [name, value] : table) {
    if (wanted && *wanted == name) return value;
  }
  return table[0].second;
}

// Outside of this many steps to or from the stability bound there is nothing but waiting or rounding errors.
constexpr double most_ratio = 1e9;

void check_step(const scene::Scene& scene, double dt, evolution::Method method) {
  const double bound = evolution::stability_bound(scene, method);
  if (!std::isfinite(bound) || (dt < most_ratio * bound && dt > bound / most_ratio)) return;
  throw text::Error(
      fmt::format("dt is too {}: {:g}", dt > bound ? "large" : "small", dt),
      fmt::format("the stability bound is {:.3g} now, and half of it is the step unless given", bound));
}

std::string counted(long number, std::string_view what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

// What `timing` tells, and the variables.
void keep_times(Session& session, const evolution::StepTimes& times) {
  if (times.steps == 0) return;
  const double per_step = 1e3 / static_cast<double>(times.steps);
  session.counter("step_forces_ms") = per_step * times.forces;
  session.counter("step_volumes_ms") = per_step * times.volumes;
  session.counter("step_surgery_ms") = per_step * times.surgery;
  session.counter("step_other_ms") = per_step * times.other;
  session.counter("step_ms") = per_step * times.sum();
  session.counter("step_facets") = times.facets / static_cast<double>(times.steps);
}

[[noreturn]] void fail(const evolution::EvolveReport& report) {
  throw text::Error(fmt::format("the film stopped moving after {}: {}", counted(report.steps, "step"),
                                solve::describe(report.ending)),
                    "the mesh may have become too uneven to go on: try u, V or refine, or more damping");
}

void refuse_what_does_not_move(const scene::Scene& scene) {
  if (scene.strings.on) {
    throw text::Error("films of one dimension do not move in time",
                      "g and hessian bring them to equilibrium, and evolve is for films with facets");
  }
  for (const scene::Quantity& quantity : scene.quantities) {
    if (quantity.role != scene::QuantityRole::fixed && quantity.role != scene::QuantityRole::conserved)
      continue;
    throw text::Error(
        fmt::format("the quantity \"{}\" is held, and motion in time holds only volumes", quantity.name),
        "g, relax and hessian hold it");
  }
}

void run(Session& session, const EvolveOptions& options) {
  scene::Scene& scene = session.scene();
  if (scene.empty()) throw text::Error("there is no film to move", "load a datafile first: load \"cube.fe\"");
  refuse_what_does_not_move(scene);
  evolution::StepSize size;
  size.fixed = options.dt;
  size.upkeep = !options.keep_mesh;
  size.method = value_of(methods, options.method);
  size.volumes = value_of(volume_modes, options.volumes);
  size.keep_energy = session.memory<TopologySwitch>().keeps_energy;
  size.topology = session.memory<TopologySwitch>().on && !options.keep_mesh;
  if (options.dt) check_step(scene, *options.dt, size.method);
  evolution::AfterStep note;
  if (MotionLog& log = session.memory<MotionLog>(); log.active())
    note = [&](evolution::Motion& motion, long) { log.note(scene, motion); };
  const evolution::EvolveReport report = evolution::evolve(
      scene, options.steps, size, session.monitor(), note,
      [&](scene::Scene&, std::span<const surgery::Event> events) { tell_events(session, events); },
      &session.memory<evolution::TopologyMemory>());
  keep_times(session, report.times);
  const bool failed = report.ending != solve::Ending::step_limit && report.ending != solve::Ending::stopped &&
                      report.ending != solve::Ending::converged && report.ending != solve::Ending::collapsed;
  if (failed) fail(report);
  if (options.dt && report.substeps > report.steps) {
    const bool stable = evolution::is_implicit(size.method) || *options.dt < report.bound;
    session.tell("dt {:g} is too long for {}: {} made in {} parts\n", *options.dt,
                 stable ? "films that come so near one another"
                        : fmt::format("stability (bound {:.3g})", report.bound),
                 counted(report.steps, "step"), report.substeps);
  }
  if (report.ending == solve::Ending::collapsed) {
    session.warn(fmt::format("stopped after {}: facets shrink to nothing, as where a neck pinches",
                             counted(report.steps, "step")));
  }
  if (report.undone > 0) session.tell("taken back and made smaller: {}\n", counted(report.undone, "step"));
  if (report.upkeeps > 0) session.tell("mesh made fit: {}\n", counted(report.upkeeps, "time"));
  const evolution::TopologyCounts& made = report.topology;
  if (made.passes > 0) {
    session.tell("mesh: {}, {}, {}; {} of topology\n", counted(made.splits, "edge") + " divided",
                 counted(made.collapses, "collapse"), counted(made.flips, "flip"),
                 counted(made.events, "change"));
  }
  session.tell("time {:.6g}: energy {:.12g}, kinetic {:.6g}, {} of {:.3g} to {:.3g}\n", scene.time,
               report.energy, report.kinetic, counted(report.substeps, "step"), report.smallest_dt,
               report.largest_dt);
}

}  // namespace

extern const Command evolve_command = make_command<EvolveOptions>(
    {.name = "evolve",
     .summary = "move the film by hyperbolic flow, volumes kept",
     .group = CommandGroup::motion},
    {positional("steps", &EvolveOptions::steps, "how many").at_least(0),
     option("dt", &EvolveOptions::dt,
            "size of a step in units of time; half the stability bound unless given")
         .above(0)
         .or_word("auto"),
     option(
         "method", &EvolveOptions::method,
         "symplectic Euler unless given; velocity Verlet; gradient flow without inertia; linearly implicit "
         "Euler; implicit midpoint")
         .one_of(names_of(methods)),
     option("volumes", &EvolveOptions::volumes,
            "in one pass where that is accurate, unless given; always in one; exact; as in the paper")
         .one_of(names_of(volume_modes)),
     flag("keep_mesh", &EvolveOptions::keep_mesh, "no flips and no averaging, however bad the mesh becomes")},
    run);

}  // namespace lamella::session::commands
