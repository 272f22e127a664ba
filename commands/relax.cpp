#include <chrono>
#include <map>

#include "evolution/levels.h"
#include "evolution/minimisers.h"
#include "evolution/relax_topology.h"
#include "session/session.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

using evolution::Minimiser;

struct RelaxOptions {
  std::optional<long> steps;
  std::optional<std::string> method;
  std::optional<std::string> motion;
  std::optional<std::string> saddle;
  std::optional<long> levels;
  std::optional<double> to;
  double facets = 4e6;
  bool keep_mesh = false;
  bool topology = false;
  double tolerance = 1e-10;
};

constexpr long most_iterations = 5000;

const std::map<std::string, Minimiser>& methods() {
  static const std::map<std::string, Minimiser> table{{"descent", Minimiser::descent},
                                                      {"cg", Minimiser::conjugate},
                                                      {"lbfgs", Minimiser::lbfgs},
                                                      {"newton", Minimiser::newton}};
  return table;
}

void check(const RelaxOptions& options) {
  const bool gradient = options.method == "descent" || options.method == "cg";
  if (gradient && options.motion)
    throw text::Error("descent by gradients knows no kinds of motion", "motion belongs to lbfgs and newton");
  if (options.levels && options.to)
    throw text::Error("levels and to exclude each other", "to refines as often as it takes");
  if ((options.levels || options.to) && options.method)
    throw text::Error("levels are relaxed by all methods in turn", "leave the method out");
  if (options.topology && (options.levels || options.to || options.method || options.keep_mesh))
    throw text::Error("the topology changes on the way of relax alone",
                      "relax topology first, then levels, to or a method");
}

evolution::LevelsReport relax(Session& session, const RelaxOptions& options) {
  evolution::RelaxOptions wanted;
  wanted.most_iterations = options.steps.value_or(most_iterations);
  wanted.tolerance = options.tolerance;
  wanted.upkeep = !options.keep_mesh;
  wanted.leave_saddle = options.saddle == "leave";
  if (options.motion)
    wanted.motion = *options.motion == "full" ? solve::MotionKind::full : solve::MotionKind::normal;
  scene::Scene& scene = session.scene();
  if (options.to) return evolution::relax_to(scene, *options.to, options.facets, wanted, session.monitor());
  if (options.levels) return evolution::relax_levels(scene, *options.levels, wanted, session.monitor());
  evolution::LevelsReport report;
  if (options.topology) {
    report.relax = relax_with_topology(
        scene, wanted, session.monitor(),
        [&](scene::Scene&, std::span<const surgery::Event> events) { tell_events(session, events); });
    return report;
  }
  report.relax = options.method ? relax_by(methods().at(*options.method), scene, wanted, session.monitor())
                                : evolution::relax(scene, wanted, session.monitor());
  return report;
}

// What is known of the equilibrium, and what may help.
std::string nature(const evolution::RelaxReport& report, bool topology) {
  const solve::Stability& stability = report.stability;
  const auto many = [](std::size_t count, const char* word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
  };
  if (report.ending == solve::Ending::collapsed)
    return fmt::format("facets vanish near ({:.4g}, {:.4g}, {:.4g}){}", report.pinch.x, report.pinch.y,
                       report.pinch.z, topology ? "" : " (relax topology lets the film pinch)");
  if (!stability.known) return "stability not known";
  if (stability.negative_modes > 0) {
    return "saddle with " + many(static_cast<std::size_t>(stability.negative_modes), "negative mode") +
           " (relax saddle=leave goes down from it)";
  }
  if (report.crowded > 0) {
    return "unstable: " + many(report.crowded, "place") +
           " where more than three films share an edge, or more than four borders a point" +
           (topology ? "" : " (relax topology pops them)");
  }
  return "stable";
}

void tell_levels(Session& session, const evolution::LevelsReport& report, std::optional<double> to) {
  if (report.levels.empty()) return;
  for (const evolution::Level& level : report.levels)
    session.tell("{:9} facets: energy {:.12g}\n", level.facets, level.energy);
  if (!report.extrapolation) {
    session.tell("too few levels for an estimate\n");
    return;
  }
  session.counter("relax_estimate") = report.extrapolation->estimate;
  session.counter("relax_limit") = report.extrapolation->energy;
  session.tell("estimated relative error {:.2g}, extrapolated energy {:.12g}{}\n",
               report.extrapolation->estimate, report.extrapolation->energy,
               to && !report.accurate ? ": not as accurate as asked for, see facets=" : "");
}

void tell(Session& session, const evolution::RelaxReport& report, bool topology, double seconds) {
  session.counter("residual") = session.counter("relax_residual") = report.residual;
  session.counter("converged") = session.counter("relax_converged") = report.converged() ? 1 : 0;
  session.counter("stable") = report.stable() ? 1 : 0;
  session.counter("negative_modes") = report.stability.negative_modes;
  if (report.new_meshes > 0)
    session.tell("the mesh was past mending; a new one has {} facets\n",
                 session.scene().film.triangle_count());
  if (report.saddles_left > 0)
    session.tell("left {} saddle{} on the way\n", report.saddles_left, report.saddles_left == 1 ? "" : "s");
  session.tell("{} after {} iterations: energy {:.12g}, residual {:.2g}, {:.3f} s\n",
               solve::describe(report.ending), report.iterations, report.energy, report.residual, seconds);
  session.tell("{}; smallest angle {:.1f} degrees\n", nature(report, topology),
               report.smallest_angle * 180 / M_PI);
}

void run(Session& session, const RelaxOptions& options) {
  if (session.scene().empty()) {
    throw text::Error("there is no film to relax", "load a datafile first: load \"cube.fe\"");
  }
  check(options);
  const auto start = std::chrono::steady_clock::now();
  const evolution::LevelsReport report = relax(session, options);
  const solve::Ending ending = report.relax.ending;
  if (ending == solve::Ending::not_finite || ending == solve::Ending::volume_lost) {
    throw text::Error(std::string(solve::describe(ending)), "look at v and check; g 1 may tell more");
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  tell_levels(session, report, options.to);
  tell(session, report.relax, options.topology, seconds.count());
}

}  // namespace

extern const Command relax_command = make_command<RelaxOptions>(
    {.name = "relax",
     .summary = "bring the film to an equilibrium, volumes kept",
     .group = CommandGroup::motion},
    {positional("steps", &RelaxOptions::steps,
                "at most this many iterations; as many as it takes unless given")
         .at_least(0),
     option("levels", &RelaxOptions::levels, "refine every facet and relax, so many times").at_least(0),
     option("to", &RelaxOptions::to,
            "refine where needed, until the energy's estimated relative error is this")
         .above(0),
     option("facets", &RelaxOptions::facets, "with to: at most so many facets; 4 million unless given")
         .at_least(1),
     option("saddle", &RelaxOptions::saddle, "leave: go down from a saddle, on to a minimum")
         .one_of({"leave", "keep"}),
     option("method", &RelaxOptions::method, "one solver alone, on the mesh as it is")
         .one_of({"descent", "cg", "lbfgs", "newton"}),
     option("motion", &RelaxOptions::motion,
            "how vertices move: along normals only, or anywhere; in turn unless given")
         .one_of({"normal", "full"}),
     flag("keep_mesh", &RelaxOptions::keep_mesh, "no flips and no averaging on the way"),
     flag("topology", &RelaxOptions::topology,
          "films merge, pinch, pop and swap neighbours on the way, where they would collapse or do not keep"),
     option("tolerance", &RelaxOptions::tolerance, "estimated relative excess of the energy at which to end")
         .above(0)},
    run);

}  // namespace lamella::session::commands
