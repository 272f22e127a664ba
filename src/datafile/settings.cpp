#include "datafile/settings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "datafile/phases.h"
#include "datafile/top_values.h"
#include "scene/periods.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using language::Token;

constexpr double most_order = 100;

double number_after(Reading& reading, const Token& word) {
  return top_value(reading, fmt::format("\"{}\" needs a number", word.text));
}

void read_scale(Reading& reading, const Token& word) {
  reading.scene.scale.value = number_after(reading, word);
  if (!reading.tokens.peek().is_word("fixed")) return;
  reading.tokens.take();
  reading.scene.scale.fixed = true;
}

int order_after(Reading& reading, const Token& word) {
  const text::Place place = reading.tokens.peek().place;
  const double order = number_after(reading, word);
  if (order >= 0 && order <= most_order) return static_cast<int>(order);
  throw text::Error(place, fmt::format("the degree of polynomials to be integrated goes from 0 to {}, not {}",
                                       most_order, order));
}

void read_edge_order(Reading& reading, const Token& word) {
  reading.scene.edge_integral_order = order_after(reading, word);
}

void read_facet_order(Reading& reading, const Token& word) {
  reading.scene.facet_integral_order = order_after(reading, word);
}

// The old word for both: so many points along an edge, and the degree over a facet.
void read_order(Reading& reading, const Token& word) {
  const int order = std::max(1, order_after(reading, word));
  reading.scene.edge_integral_order = 2 * order - 1;
  reading.scene.facet_integral_order = order;
}

// Films of edges, in a plane or in space, or of facets in space.
void read_space_dimension(Reading& reading, const Token& word) {
  const double dimension = number_after(reading, word);
  reading.dimension_place = word.place;
  reading.scene.strings.dimension = static_cast<int>(dimension);
  if (dimension != 2 && dimension != 3)
    reading.refuse(word.place, text::lower(word.text), "only spaces of two and three dimensions are");
}

void read_surface_dimension(Reading& reading, const Token& word) {
  const double dimension = number_after(reading, word);
  reading.scene.strings.on = dimension == 1;
  if (dimension != 1 && dimension != 2)
    reading.refuse(word.place, text::lower(word.text), "only films of one and two dimensions are");
}

// Space that repeats itself, in unit cubes until told otherwise. Whether bodies fill it shows by itself.
void read_torus(Reading& reading, const Token&) {
  if (!reading.periods) reading.periods = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

// The group of translations by whole periods is known; there edges tell their wraps by number.
void read_symmetry_group(Reading& reading, const Token& word) {
  const Token name = reading.tokens.take();
  if (text::lower(name.text).find("torus") == std::string::npos)
    return reading.refuse(word.place, "symmetry_group", "symmetry groups");
  read_torus(reading, word);
  reading.wraps_are_attributes = true;
}

// Ways of moving that `g` does not have: they change nothing of what is loaded.
void read_way_of_moving(Reading& reading, const Token& word) {
  if (top_value_follows(reading)) number_after(reading, word);
  reading.findings.warning(
      word.place, fmt::format("\"{}\" is not supported: g will move without it", text::lower(word.text)));
}

// Kept as formulas where they name variables.
void read_periods(Reading& reading, const Token& word) {
  const int dimension = reading.scene.strings.dimension;
  std::vector<language::Formula>& formulas = reading.scene.periods;
  formulas.clear();
  for (int i = 0; i < dimension * dimension; ++i) {
    const Token next = reading.tokens.peek();
    if (next.is_word("total_time"))
      throw text::Error(next.place, "periods do not change with time", "name a parameter, and set it");
    formulas.push_back(top_value_of_variables(
        reading, fmt::format("\"{}\" needs as many vectors as space has dimensions", word.text)));
  }
  try {
    reading.periods = scene::present_periods(reading.scene);
  } catch (const text::Error& error) {
    throw error.placed_at(word.place);
  }
  const bool varies = std::any_of(formulas.begin(), formulas.end(), [](const language::Formula& formula) {
    return formula.depends_on_variables();
  });
  if (!varies) formulas.clear();
  for (const scene::FreeParameter& parameter : reading.scene.parameters) {
    if (!parameter.fixed && scene::periods_read(reading.scene, parameter.variable))
      reading.refuse(word.place, word.text, "periods of optimizing parameters");
  }
}

// Ways of measuring that differ only where edges are curved, which they never are here.
void read_method_name(Reading& reading, const Token& word) {
  constexpr std::array<std::string_view, 6> straight = {
      "edge_length", "circular_arc_length", "edge_area", "circular_arc_area", "facet_area", "facet_volume"};
  const Token name = reading.tokens.peek();
  if (!name.is(language::TokenKind::string))
    throw text::Error(name.place, fmt::format("\"{}\" needs the name of a method, in quotes", word.text));
  reading.tokens.take();
  if (std::find(straight.begin(), straight.end(), text::lower(name.content)) == straight.end())
    return reading.refuse(word.place, word.text, "ways of measuring that are not straight");
  reading.scene.cosmetics.push_back({text::lower(word.text), std::string(name.text)});
}

constexpr std::array<Setting, 32> setting_table = {{
    {"area_method_name", read_method_name},
    {"length_method_name", read_method_name},
    {"volume_method_name", read_method_name},
    {"torus", read_torus},
    {"symmetry_group", read_symmetry_group},
    {"autopop", read_way_of_moving},
    {"autochop", read_way_of_moving},
    {"area_normalization", read_way_of_moving},
    {"torus_filled", read_torus},
    {"periods", read_periods},
    {"torus_periods", read_periods},
    {"gravity_constant",
     [](Reading& r, const Token& word) { r.scene.gravity.constant = number_after(r, word); }},
    {"scale", read_scale},
    {"scale_limit", [](Reading& r, const Token& word) { r.scene.scale.limit = number_after(r, word); }},
    {"total_time", [](Reading& r, const Token& word) { r.scene.time = number_after(r, word); }},
    {"symmetric_content", [](Reading& r, const Token&) { r.scene.symmetric_content = true; }},
    {"gap_constant", [](Reading& r, const Token& word) { r.scene.gap_constant = number_after(r, word); }},
    {"spring_constant", [](Reading& r, const Token& word) { r.scene.gap_constant = number_after(r, word); }},
    {"integral_order", read_order},
    {"integral_order_1d", read_edge_order},
    {"integral_order_2d", read_facet_order},
    {"integration_order", read_order},
    {"integration_order_1d", read_edge_order},
    {"integration_order_2d", read_facet_order},
    {"constraint_tolerance",
     [](Reading& r, const Token& word) { r.scene.constraint_tolerance = number_after(r, word); }},
    {"interp_bdry_param", [](Reading& r, const Token&) { r.scene.interpolate_parameters = true; }},
    {"phasefile", read_phasefile},
    {"keep_originals", [](Reading& r, const Token&) { r.keep_originals = true; }},
    {"keep_macros", [](Reading& r, const Token&) { r.keep_macros = true; }},
    {"string", [](Reading& r, const Token&) { r.scene.strings.on = true; }},
    {"space_dimension", read_space_dimension},
    {"surface_dimension", read_surface_dimension},
}};

constexpr std::array<SettingParameter, 7> parameter_table = {{
    {"lamella_mesh_fitness", [](const scene::Scene& s) { return s.mesh_fitness; },
     [](scene::Scene& s, double value) { s.mesh_fitness = value; }, 0},
    {"lamella_steps_unkept", [](const scene::Scene& s) { return s.steps_unkept; },
     [](scene::Scene& s, double value) { s.steps_unkept = value; }, 0},
    {"lamella_mass_of_area", [](const scene::Scene& s) { return s.mass_of_area ? 1.0 : 0.0; },
     [](scene::Scene& s, double value) { s.mass_of_area = value != 0; }, 0},
    {"lamella_wind_pressure", [](const scene::Scene& s) { return s.forces.wind_pressure; },
     [](scene::Scene& s, double value) { s.forces.wind_pressure = value; }, 1},
    {"lamella_work", [](const scene::Scene& s) { return s.work; },
     [](scene::Scene& s, double value) { s.work = value; }, 0},
    {"lamella_keep_volumes", [](const scene::Scene& s) { return s.keep_volumes ? 1.0 : 0.0; },
     [](scene::Scene& s, double value) { s.keep_volumes = value != 0; }, 1},
    {"lamella_damping", [](const scene::Scene& s) { return s.damping; },
     [](scene::Scene& s, double value) { s.damping = value; }, 0},
}};

}  // namespace

std::span<const Setting> settings() {
  return setting_table;
}

const Setting* find_setting(std::string_view word) {
  const std::string key = text::lower(word);
  const auto at = std::find_if(setting_table.begin(), setting_table.end(),
                               [&](const Setting& s) { return s.word == key; });
  return at == setting_table.end() ? nullptr : &*at;
}

std::span<const SettingParameter> setting_parameters() {
  return parameter_table;
}

const SettingParameter* find_setting_parameter(std::string_view name) {
  const std::string key = text::lower(name);
  const auto at = std::find_if(parameter_table.begin(), parameter_table.end(),
                               [&](const SettingParameter& p) { return p.name == key; });
  return at == parameter_table.end() ? nullptr : &*at;
}

}  // namespace lamella::datafile
