#include "datafile/settings.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "datafile/top_values.h"
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

// The only dimension that there is may be stated.
void require_dimension(Reading& reading, const Token& word, double wanted, std::string_view feature) {
  if (number_after(reading, word) != wanted) reading.refuse(word.place, text::lower(word.text), feature);
}

constexpr std::array<Setting, 19> setting_table = {{
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
    {"keep_originals", [](Reading& r, const Token&) { r.keep_originals = true; }},
    {"keep_macros", [](Reading& r, const Token&) { r.keep_macros = true; }},
    {"space_dimension",
     [](Reading& r, const Token& word) {
       require_dimension(r, word, 3, "only space of three dimensions is");
     }},
    {"surface_dimension",
     [](Reading& r, const Token& word) {
       require_dimension(r, word, 2, "only films of two dimensions are");
     }},
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
