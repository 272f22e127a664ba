#include "session/switches.h"

#include <algorithm>
#include <map>
#include <string>

#include "session/session.h"
#include "text/suggest.h"

namespace lamella::session {

namespace {

constexpr SwitchEffect acts = SwitchEffect::acts;
constexpr SwitchEffect kept = SwitchEffect::kept;
constexpr SwitchEffect refused = SwitchEffect::refused;

constexpr std::string_view flows = "g moves vertices down the gradient; see evolve for motion in time";
constexpr std::string_view popping =
    "nothing is popped or collapsed on its own: delete edges where ..., refine edges where ...";
constexpr std::string_view gas = "bodies have volumes or pressures, and are not filled with gas";
constexpr std::string_view curvature = "curvature is no energy here";
constexpr std::string_view curved = "facets are flat and edges straight here";
constexpr std::string_view careful = "edges are collapsed and flipped only where the film stays sound";
constexpr std::string_view newton = "relax and hessian use the exact Hessian";

constexpr Switch switch_table[] = {
    {"gravity",
     acts,
     true,
     {},
     {},
     [](Session& s) { return s.scene().gravity.on; },
     [](Session& s, bool on) { s.scene().gravity.on = on; }},
    {"quiet",
     acts,
     false,
     {},
     {},
     [](Session& s) { return s.quiet(); },
     [](Session& s, bool on) { s.set_quiet(on); }},
    {"transforms",
     acts,
     false,
     {},
     {},
     [](Session& s) { return s.scene().view_transforms.on; },
     [](Session& s, bool on) { s.scene().view_transforms.on = on; }},
    // --- windows, pictures, files
    {"autodisplay", kept, true, "D"},
    {"backcull"},
    {"big_endian"},
    {"circular_arc_draw"},
    {"clip_view"},
    {"clipped"},
    {"colormap"},
    {"conf_edge"},
    {"connected"},
    {"detorus_sticky", kept, true},
    {"facet_colors", kept, true},
    {"full_bounding_box"},
    {"gv_binary"},
    {"interp_normals"},
    {"little_endian"},
    {"no_dump"},
    {"ps_cmykflag"},
    {"ps_colorflag"},
    {"ps_crossingflag"},
    {"ps_gridflag"},
    {"ps_labelflag"},
    {"raw_cells"},
    {"rgb_colors"},
    {"rotate_lights"},
    {"shading", kept, true},
    {"show_all_edges"},
    {"show_bounding_box"},
    {"show_inner", kept, true},
    {"show_outer", kept, true},
    {"slice_view"},
    {"smooth_graph"},
    {"thicken", kept, true},
    {"view_4d"},
    {"view_transforms_use_unique_point"},
    {"visibility_test"},
    // --- messages
    {"break_after_warning"},
    {"break_on_warning"},
    {"debug"},
    {"estimate"},
    {"hessian_quiet", kept, true},
    {"itdebug"},
    {"memdebug"},
    {"quietgo"},
    {"quietload"},
    {"show_all_quantities"},
    {"verbose"},
    // --- how the same is computed
    {"assume_oriented"},
    {"augmented_hessian"},
    {"autorecalc", kept, true},
    {"blas_flag"},
    {"bunch_kaufman"},
    {"calculate_in_3d"},
    {"check_increase"},
    {"function_quantity_sparse"},
    {"hessian_normal", kept, true},
    {"linear_metric"},
    {"mean_curvature_integral"},
    {"metis_factor"},
    {"metric_conversion"},
    {"metric_convert"},
    {"old_area"},
    {"post_project"},
    {"quantities_only"},
    {"ribiere", kept, true},
    {"sparse_constraints", kept, true},
    {"volgrads_every"},
    {"ysmp"},
    {"convert_to_quantities"},
    // --- what would change the steps
    {"ambient_pressure", refused, false, {}, gas},
    {"approximate_curvature", refused, false, {}, flows},
    {"approx_curvature", refused, false, {}, flows},
    {"area_normalization", refused, false, "a", flows},
    {"autochop", refused, false, {}, popping},
    {"autopop", refused, false, {}, popping},
    {"autopop_quartic", refused, false, {}, popping},
    {"bezier_basis", refused, false, {}, curved},
    {"boundary_curvature", refused, false, {}, curvature},
    {"deturck", refused, false, {}, flows},
    {"diffusion", refused, false, {}, gas},
    {"dirichlet_mode", refused, false, {}, newton},
    {"effective_area", refused, false, {}, flows},
    {"force_deletion", refused, false, {}, careful},
    {"force_edgeswap", refused, false, {}, careful},
    {"hessian_diff", refused, false, {}, newton},
    {"hessian_normal_one", refused, false, {}, newton},
    {"hessian_normal_perp", refused, false, {}, newton},
    {"hessian_special_normal", refused, false, {}, newton},
    {"homothety", refused, false, "W", flows},
    {"immediate_autopop", refused, false, {}, popping},
    {"interp_bdry_param", kept},
    {"jiggle", refused, false, "J", "vertices are shaken by j, when it is told to"},
    {"k_altitude_mode", refused, false, {}, "K halves edges in their middle"},
    {"kusner", refused, false, {}, curvature},
    {"normal_motion", refused, false, {}, flows},
    {"pinning", refused, false, {}, flows},
    {"runge_kutta", refused, false, {}, flows},
    {"self_similar", refused, false, {}, flows},
    {"sobolev_mode", refused, false, {}, newton},
    {"squared_gradient", refused, false, {}, newton},
    {"star_finagling", refused, false, {}, careful},
    {"zener_drag", refused, false, {}, flows},
};

// States of the switches that are kept, where they are not what they were in the beginning.
struct KeptStates {
  std::map<std::string_view, bool> states;
};

struct SwitchOptions {
  std::optional<std::string> state;
};

// `Area normalization` of area_normalization
std::string title(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '_', ' ');
  result.front() = static_cast<char>(result.front() - 'a' + 'A');
  return result;
}

Command made_command(const Switch& known) {
  Command command;
  command.name = known.name;
  if (!known.letter.empty()) command.aliases = {std::string(known.letter)};
  command.summary = "a switch: see help switches";
  command.arguments = {positional("state", &SwitchOptions::state, "on unless given").one_of({"on", "off"})};
  command.run = [&known](Session& session, std::span<const Given> given) {
    bool on = true;
    if (!given.empty()) on = std::get<std::string>(given.front().value) == "on";
    const bool before = is_on(session, known);
    turn(session, known, on);
    if (known.effect == acts)
      session.tell("{} {}. (was {})\n", title(known.name), on ? "ON" : "OFF", before ? "on" : "off");
  };
  return command;
}

const std::vector<Command>& commands() {
  static const std::vector<Command> made = [] {
    std::vector<Command> result;
    for (const Switch& known : switch_table) result.push_back(made_command(known));
    return result;
  }();
  return made;
}

}  // namespace

std::span<const Switch> switches() {
  return switch_table;
}

const Switch* find_switch(std::string_view word) {
  const std::string key = text::lower(word);
  const auto* const at = std::find_if(
      std::begin(switch_table), std::end(switch_table),
      [&](const Switch& known) { return word.size() == 1 ? known.letter == word : known.name == key; });
  return at == std::end(switch_table) ? nullptr : at;
}

bool is_on(Session& session, const Switch& known) {
  if (known.get != nullptr) return known.get(session);
  const auto& states = session.memory<KeptStates>().states;
  const auto at = states.find(known.name);
  return at == states.end() ? known.initial : at->second;
}

void reset_switches(Session& session) {
  session.memory<KeptStates>().states.clear();
}

void turn(Session& session, const Switch& known, bool on) {
  if (known.set != nullptr) {
    known.set(session, on);
    return;
  }
  if (known.effect == refused && on)
    throw text::Error(fmt::format("{} is not supported: {}", known.name, known.why));
  session.memory<KeptStates>().states[known.name] = on;
}

const Command* find_switch_command(std::string_view word) {
  const Switch* const known = find_switch(word);
  return known == nullptr ? nullptr : &commands()[static_cast<std::size_t>(known - std::begin(switch_table))];
}

}  // namespace lamella::session
