#include "session/internal_variables.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "energy/plateau.h"
#include "evolution/balance.h"
#include "session/program.h"
#include "session/session.h"
#include "session/switches.h"
#include "text/error.h"
#include "text/suggest.h"

namespace lamella::session {

using language::Value;

namespace {

Value count(std::uint32_t number) {
  return static_cast<double>(number);
}

double positive(double value, std::string_view name) {
  if (!(value > 0) || !std::isfinite(value))
    throw text::Error(fmt::format("{} must be positive, not {:.15g}", name, value));
  return value;
}

double finite(double value, std::string_view name) {
  if (!std::isfinite(value)) throw text::Error(fmt::format("{} cannot be {}", name, value));
  return value;
}

std::string date_and_time() {
  std::time_t now = std::time(nullptr);
  std::tm local = {};
  ::localtime_r(&now, &local);
  return fmt::format("{:%a %b %e %H:%M:%S %Y}", local);
}

evolution::Balance motion(const Session& session) {
  return evolution::balance(session.scene());
}

double jiggle_temperature(Session& session) {
  constexpr double usual = 0.05;
  const double set = session.counter("jiggle_temperature");
  return set > 0 ? set : usual;
}

// A counter that commands leave behind.
template <std::size_t n>
struct Literal {
  // NOLINTNEXTLINE(google-explicit-constructor): a template argument
  constexpr Literal(const char (&text)[n]) { std::copy_n(text, n, content); }
  char content[n];
};
template <Literal name>
Value counter(Session& session) {
  return session.counter(name.content);
}

// A value that is kept and has no effect here: of windows, and of methods that go another way.
template <Literal name>
void keep(Session& session, double value) {
  session.counter(name.content) = value;
}
template <Literal name>
InternalVariable kept() {
  return {name.content, "accepted, without effect", counter<name>, keep<name>};
}

const InternalVariable variable_table[] = {
    {"total_area", "area of all facets", [](Session& s) -> Value { return s.measures().area; }, nullptr},
    {"total_energy", "energy of the scene", [](Session& s) -> Value { return s.measures().energy; }, nullptr},
    {"total_length", "length of all edges", [](Session& s) -> Value { return s.measures().length; }, nullptr},
    {"total_time", "time that evolution has passed, in s", [](Session& s) -> Value { return s.scene().time; },
     [](Session& s, double value) { s.scene().time = finite(value, "total_time"); }},
    {"vertex_count", "number of vertices", [](Session& s) { return count(s.scene().film.vertex_count()); },
     nullptr},
    {"edge_count", "number of edges", [](Session& s) { return count(s.scene().film.edge_count()); }, nullptr},
    {"facet_count", "number of facets", [](Session& s) { return count(scene::facet_count(s.scene())); },
     nullptr},
    {"facetedge_count", "number of sides of facets",
     [](Session& s) { return count(3 * s.scene().film.triangle_count()); }, nullptr},
    {"body_count", "number of bodies", [](Session& s) { return count(scene::body_count(s.scene())); },
     nullptr},
    {"gravity_constant", "strength of gravity, along -z",
     [](Session& s) -> Value { return s.scene().gravity.constant; },
     [](Session& s, double value) { s.scene().gravity.constant = finite(value, "gravity_constant"); }},
    {"scale", "step of g: the last, or the one fixed by m",
     [](Session& s) -> Value { return s.scene().scale.value; },
     [](Session& s, double value) { s.scene().scale.value = positive(value, "scale"); }},
    {"damping", "damping of hyperbolic flow, in 1/s", [](Session& s) -> Value { return s.scene().damping; },
     [](Session& s, double value) {
       if (!(value >= 0) || !std::isfinite(value))
         throw text::Error(fmt::format("damping cannot be {:.15g}", value));
       s.scene().damping = value;
     }},
    {"kinetic_energy", "of the moving film", [](Session& s) -> Value { return motion(s).kinetic; }, nullptr},
    {"momentum_x", "of the moving film", [](Session& s) -> Value { return motion(s).momentum.x; }, nullptr},
    {"momentum_y", "of the moving film", [](Session& s) -> Value { return motion(s).momentum.y; }, nullptr},
    {"momentum_z", "of the moving film", [](Session& s) -> Value { return motion(s).momentum.z; }, nullptr},
    {"angular_momentum_x", "of the moving film, about the origin",
     [](Session& s) -> Value { return motion(s).angular_momentum.x; }, nullptr},
    {"angular_momentum_y", "of the moving film, about the origin",
     [](Session& s) -> Value { return motion(s).angular_momentum.y; }, nullptr},
    {"angular_momentum_z", "of the moving film, about the origin",
     [](Session& s) -> Value { return motion(s).angular_momentum.z; }, nullptr},
    {"outer_work", "done on the moving film by force and wind, less what damping took",
     [](Session& s) -> Value { return s.scene().work; }, nullptr},
    {"step_ms", "wall time of a step of the last evolve, parts counted", counter<"step_ms">, nullptr},
    {"step_forces_ms", "of it, forces and implicit systems", counter<"step_forces_ms">, nullptr},
    {"step_volumes_ms", "of it, volumes", counter<"step_volumes_ms">, nullptr},
    {"step_surgery_ms", "of it, the mesh kept fit", counter<"step_surgery_ms">, nullptr},
    {"step_other_ms", "of it, all else", counter<"step_other_ms">, nullptr},
    {"step_facets", "facets that a step of the last evolve moved", counter<"step_facets">, nullptr},
    {"triple_angle_rms", "root mean square deviation from 120 degrees along triple lines, in degrees",
     [](Session& s) -> Value { return energy::plateau_angles(s.scene().film).triple.rms; }, nullptr},
    {"quad_angle_rms", "root mean square deviation from 109.47 degrees at quad points, in degrees",
     [](Session& s) -> Value { return energy::plateau_angles(s.scene().film).quad.rms; }, nullptr},
    {"space_dimension", "3", [](Session&) -> Value { return 3.0; }, nullptr},
    {"surface_dimension", "2", [](Session&) -> Value { return 2.0; }, nullptr},
    {"datafilename", "path of the datafile", [](Session& s) -> Value { return s.scene().name; }, nullptr},
    {"date_and_time", "the present date and time", [](Session&) -> Value { return date_and_time(); },
     nullptr},
    {"clock", "processor time used so far, in s",
     [](Session&) -> Value { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }, nullptr},
    {"random", "a random number between 0 and 1",
     [](Session& s) -> Value { return std::uniform_real_distribution<double>()(s.random()); }, nullptr},
    {"random_seed", "seed of the random numbers", [](Session& s) -> Value { return s.random_seed(); },
     [](Session& s, double value) { s.seed_random(finite(value, "random_seed")); }},
    {"refine_count", "edges split by the last refine", counter<"refine_count">, nullptr},
    {"edge_refine_count", "edges split by the last refine or l", counter<"edge_refine_count">, nullptr},
    {"facet_refine_count", "facets cut by the last refine", counter<"facet_refine_count">, nullptr},
    {"last_eigenvalue", "lowest mode found by the last eigen or saddle", counter<"last_eigenvalue">, nullptr},
    {"relax_estimate", "estimated relative error of the energy after the last relax with levels or to",
     counter<"relax_estimate">, nullptr},
    {"relax_limit", "energy in the limit of ever finer meshes, by the last relax with levels or to",
     counter<"relax_limit">, nullptr},
    {"converged", "whether the last relax converged", counter<"converged">, nullptr},
    {"residual", "estimated relative excess of the energy after the last relax", counter<"residual">,
     nullptr},
    {"stable", "whether the last relax found a minimum", counter<"stable">, nullptr},
    {"negative_modes", "negative modes of the equilibrium that the last relax found",
     counter<"negative_modes">, nullptr},
    {"relax_residual", "estimated relative excess of the energy after the last relax",
     counter<"relax_residual">, nullptr},
    {"relax_converged", "whether the last relax converged", counter<"relax_converged">, nullptr},
    {"equi_count", "edges switched by the last equiangulation", counter<"equi_count">, nullptr},
    {"fix_count", "elements fixed by the last fix", counter<"fix_count">, nullptr},
    {"unfix_count", "elements freed by the last unfix", counter<"unfix_count">, nullptr},
    {"check_count", "faults found by the last check", counter<"check_count">, nullptr},
    {"edge_delete_count", "edges that the last delete or t collapsed", counter<"edge_delete_count">, nullptr},
    {"facet_delete_count", "facets that the last delete or w took away", counter<"facet_delete_count">,
     nullptr},
    {"edgeswap_count", "edges switched by the last edgeswap", counter<"edgeswap_count">, nullptr},
    {"notch_count", "edges notched by the last n", counter<"notch_count">, nullptr},
    {"vertex_dissolve_count", "vertices dissolved last", counter<"vertex_dissolve_count">, nullptr},
    {"edge_dissolve_count", "edges dissolved last", counter<"edge_dissolve_count">, nullptr},
    {"vertex_pop_count", "vertices resolved last", counter<"vertex_pop_count">, nullptr},
    {"edge_pop_count", "edges of many films resolved last", counter<"edge_pop_count">, nullptr},
    {"pop_count", "resolved by pop last", counter<"pop_count">, nullptr},
    {"pop_edge_to_tri_count", "edges made facets last", counter<"pop_edge_to_tri_count">, nullptr},
    {"pop_tri_to_edge_count", "facets made edges last", counter<"pop_tri_to_edge_count">, nullptr},
    {"t1_edgeswap_count", "strings turned by the last t1_edgeswap", counter<"t1_edgeswap_count">, nullptr},
    {"burst_count", "films or bodies that burst last", counter<"burst_count">, nullptr},
    {"facet_dissolve_count", "facets dissolved last", counter<"facet_dissolve_count">, nullptr},
    {"body_dissolve_count", "bodies dissolved last", counter<"body_dissolve_count">, nullptr},
    {"jiggle_temperature", "how far j shakes, in mean edge lengths",
     [](Session& s) -> Value { return jiggle_temperature(s); },
     [](Session& s, double value) {
       s.counter("jiggle_temperature") = positive(value, "jiggle_temperature");
     }},
    {"transform_expr", "how pictures repeat the scene",
     [](Session& s) -> Value { return s.scene().view_transforms.expression; }, nullptr},
    {"evolver_version", "version of the program", [](Session&) -> Value { return std::string(version()); },
     nullptr},
    kept<"background">(),
    kept<"brightness">(),
    kept<"hessian_slant_cutoff">(),
    kept<"linear_metric_mix">(),
    kept<"ps_bareedgewidth">(),
    kept<"ps_conedgewidth">(),
    kept<"ps_fixededgewidth">(),
    kept<"ps_gridedgewidth">(),
    kept<"ps_labelsize">(),
    kept<"ps_stringwidth">(),
    kept<"ps_tripleedgewidth">(),
    kept<"scale_scale">(),
    kept<"scrollbuffersize">(),
    kept<"target_tolerance">(),
    kept<"thickness">(),
    kept<"window_aspect_ratio">(),
};

}  // namespace

namespace {

InternalVariable variable_of(const Switch& known) {
  return {known.name, "1 if it is on, else 0",
          [&known](Session& s) -> Value { return is_on(s, known) ? 1.0 : 0.0; },
          [&known](Session& s, double value) { turn(s, known, value != 0); }};
}

}  // namespace

std::span<const InternalVariable> internal_variables() {
  static const std::vector<InternalVariable> all = [] {
    std::vector<InternalVariable> made(std::begin(variable_table), std::end(variable_table));
    for (const Switch& known : switches()) made.push_back(variable_of(known));
    return made;
  }();
  return all;
}

std::optional<language::InternalId> find_internal_variable(std::string_view name) {
  const std::string key = text::lower(name);
  const std::span<const InternalVariable> all = internal_variables();
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (all[i].name == key) return language::InternalId{i};
  }
  return std::nullopt;
}

const InternalVariable& internal_variable(language::InternalId id) {
  return internal_variables()[id.row];
}

}  // namespace lamella::session
