#include "datafile/write.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/force_settings.h"
#include "datafile/put.h"
#include "datafile/settings.h"
#include "datafile/title.h"
#include "datafile/write_commands.h"
#include "datafile/write_constraints.h"
#include "datafile/write_elements.h"
#include "datafile/write_quantities.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;

// Whether bodies fill space.
bool is_filled(const scene::Scene& scene) {
  const auto& pairs = scene.film.connectivity().triangle_regions;
  return std::none_of(pairs.begin(), pairs.end(), [](const film::RegionPair& pair) {
    return pair.front == film::outside_region || pair.behind == film::outside_region;
  });
}

void write_settings(std::string& out, const scene::Scene& scene) {
  const scene::Scene blank;
  if (scene.strings.on) put(out, "string\nspace_dimension {}\n", scene.strings.dimension);
  if (scene.gravity.constant != blank.gravity.constant)
    put(out, "gravity_constant {}\n", scene.gravity.constant);
  if (scene.scale.value != blank.scale.value || scene.scale.fixed) {
    put(out, "scale {}{}\n", scene.scale.value, scene.scale.fixed ? " fixed" : "");
  }
  if (scene.scale.limit != blank.scale.limit) put(out, "scale_limit {}\n", scene.scale.limit);
  if (scene.time != blank.time) put(out, "total_time {}\n", scene.time);
  if (scene.symmetric_content) out += "symmetric_content\n";
  if (scene.gap_constant != blank.gap_constant) put(out, "gap_constant {}\n", scene.gap_constant);
  if (scene.edge_integral_order != blank.edge_integral_order)
    put(out, "integral_order_1d {}\n", scene.edge_integral_order);
  if (scene.constraint_tolerance != blank.constraint_tolerance)
    put(out, "constraint_tolerance {}\n", scene.constraint_tolerance);
  if (scene.facet_integral_order != blank.facet_integral_order)
    put(out, "integral_order_2d {}\n", scene.facet_integral_order);
  if (scene.interpolate_parameters) out += "interp_bdry_param\n";
  for (const SettingParameter& setting : setting_parameters()) {
    if (setting.get(scene) != setting.blank)
      put(out, "parameter {} = {}\n", setting.name, setting.get(scene));
  }
}

void write_parameters(std::string& out, const scene::Scene& scene) {
  const std::set<language::VariableId> read = variables_of_formulas(scene);
  scene.variables.for_each([&](language::VariableId id, const language::Variable& variable) {
    if (scene.variables.name(id).find('.') != std::string::npos) return;  // part of a quantity
    const std::string value = written_value(variable.value);
    const auto free = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                   [&](const scene::FreeParameter& p) { return p.variable == id; });
    if (free != scene.parameters.end() && !value.empty()) {
      put(out, "{} {} = {} pdelta = {} pscale = {}\n", free->fixed ? "parameter" : "optimizing_parameter",
          scene.variables.name(id), value, free->delta, free->scale);
    } else if ((variable.parameter || read.contains(id)) && !value.empty()) {
      put(out, "parameter {} = {}\n", scene.variables.name(id), value);
    }
  });
}

// Values stand one after the other on a line: what has spaces in it needs brackets to be one.
std::string bracketed(const std::string& formula) {
  int open = 0;
  for (const char c : formula) {
    open += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ' ' && open == 0) return "(" + formula + ")";
  }
  return formula;
}

// After the parameters, which they may name.
void write_periods(std::string& out, const scene::Scene& scene) {
  if (!scene.film.periodic()) return;
  out += !scene.strings.on && is_filled(scene) ? "torus_filled\nperiods\n" : "torus\nperiods\n";
  const std::size_t dimension = scene.strings.on && scene.strings.dimension == 2 ? 2 : 3;
  for (std::size_t row = 0; row < dimension; ++row) {
    const film::Vec3& p = scene.film.lattice()->periods()[row];
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      out += axis == 0 ? "" : " ";
      out += scene.periods.empty() ? fmt::format("{}", p[static_cast<int>(axis)])
                                   : bracketed(scene.periods[row * dimension + axis].text());
    }
    out += '\n';
  }
}

void write_declaration(std::string& out, ElementKind kind, const film::Column& column) {
  const bool integer = std::holds_alternative<film::Integers>(column.data);
  put(out, "define {} attribute {} {}", film::name_of(kind), column.name, integer ? "integer" : "real");
  for (const int size : column.shape) put(out, "[{}]", size);
  out += '\n';
}

void write_declarations(std::string& out, const scene::Scene& scene) {
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    scene.film.columns(kind).for_each([&](const film::Column& column) {
      if (is_declared_column(kind, column)) write_declaration(out, kind, column);
    });
  }
  scene.body_columns.for_each([&](const film::Column& column) {
    if (is_declared_column(ElementKind::body, column)) write_declaration(out, ElementKind::body, column);
  });
  for (const scene::Body& body : scene.bodies) {
    if (!body.ramp || body.absent) continue;
    put(out, "define body attribute {} real[{}]\n", ramp_name, ramp_width);
    break;
  }
}

void write_cosmetics(std::string& out, const scene::Scene& scene) {
  for (const scene::CosmeticLine& line : scene.cosmetics) {
    put(out, "{}{}{}\n", line.keyword, line.text.empty() || line.text.starts_with('\n') ? "" : " ",
        line.text);
  }
}

// A datafile has signs for edges that go around a period once. In a cell no short edge does more.
bool goes_far(const film::Film& film) {
  for (std::uint32_t e = 0; film.periodic() && e < film.edge_rows(); ++e) {
    if (!film.alive(film::Edge(e))) continue;
    const film::Wrap wrap = film.wrap(film::SignedEdge(film::Edge(e), false));
    if (std::any_of(wrap.times.begin(), wrap.times.end(), [](int times) { return std::abs(times) > 1; }))
      return true;
  }
  return false;
}

std::string write_scene(const scene::Scene& scene) {
  std::string out = title_comment(scene.title);
  if (!out.empty()) out += '\n';
  const std::size_t top = out.size();
  if (needs_own_numbers(scene)) out += "keep_originals\n";
  write_settings(out, scene);
  write_parameters(out, scene);
  write_periods(out, scene);
  write_forces(out, scene.forces);
  write_declarations(out, scene);
  write_constraints(out, scene);
  write_quantities(out, scene);
  write_cosmetics(out, scene);
  if (out.size() > top) out += '\n';
  write_elements(out, scene);
  write_commands(out, scene);
  return out;
}

}  // namespace

std::string write_datafile(const scene::Scene& scene) {
  if (!goes_far(scene.film)) return write_scene(scene);
  scene::Scene gathered = scene;
  gathered.film.gather_in_cell();
  return write_scene(gathered);
}

}  // namespace lamella::datafile
