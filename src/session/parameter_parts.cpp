#include "session/parameter_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/periods.h"
#include "text/error.h"
#include "text/suggest.h"

namespace lamella::session {

namespace {

constexpr std::uint32_t first_parameter_row =
    900000;  // above all internal variables, below the parts of quantities
constexpr std::uint32_t last_parameter_row = 1000000;

void refuse_in_periods(const scene::Scene& scene, language::VariableId variable) {
  if (!scene::periods_read(scene, variable)) return;
  const std::string& name = scene.variables.name(variable);
  throw text::Error(fmt::format("\"{}\" cannot be optimized: periods name it", name),
                    fmt::format("the film follows when it is set: {} := 1.1", name));
}

template <class Scene>
auto& parameter_of(Scene& scene, language::InternalId id) {
  const std::size_t row = (id.row - first_parameter_row) / parameter_part_names.size();
  if (row < scene.parameters.size()) return scene.parameters[row];
  throw text::Error("this parameter is no more");
}

}  // namespace

std::optional<language::InternalId> find_parameter_part(const scene::Scene& scene, std::string_view name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const auto variable = scene.variables.find_id(name.substr(0, dot));
  const auto part =
      std::find(parameter_part_names.begin(), parameter_part_names.end(), text::lower(name.substr(dot + 1)));
  if (!variable || part == parameter_part_names.end()) return std::nullopt;
  const auto parameter = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                      [&](const scene::FreeParameter& p) { return p.variable == *variable; });
  if (parameter == scene.parameters.end()) return std::nullopt;
  const auto row = static_cast<std::size_t>(parameter - scene.parameters.begin());
  return language::InternalId{first_parameter_row +
                              static_cast<std::uint32_t>(parameter_part_names.size() * row) +
                              static_cast<std::uint32_t>(part - parameter_part_names.begin())};
}

bool is_parameter_part(language::InternalId id) {
  return id.row >= first_parameter_row && id.row < last_parameter_row;
}

double parameter_part(const scene::Scene& scene, language::InternalId id) {
  const scene::FreeParameter& parameter = parameter_of(scene, id);
  switch ((id.row - first_parameter_row) % parameter_part_names.size()) {
    case 0:
      return parameter.fixed ? 1 : 0;
    case 1:
      return parameter.delta;
    case 2:
      return parameter.scale;
    case 3:
      return parameter.force;
    default:
      return parameter.velocity;
  }
}

void set_parameter_part(scene::Scene& scene, language::InternalId id, const language::Value& value) {
  scene::FreeParameter& parameter = parameter_of(scene, id);
  const std::string_view part =
      parameter_part_names[(id.row - first_parameter_row) % parameter_part_names.size()];
  const std::string name = fmt::format("{}.{}", scene.variables.name(parameter.variable), part);
  const double* const number = std::get_if<double>(&value);
  if (part == "p_force" || part == "p_velocity")
    throw text::Error(fmt::format("{} follows from the film and cannot be set", name));
  if (number == nullptr || !std::isfinite(*number)) throw text::Error(name + " must be a finite number");
  if (part == "fixed") {
    if (*number == 0) refuse_in_periods(scene, parameter.variable);
    parameter.fixed = *number != 0;
    return;
  }
  if (!(*number > 0)) throw text::Error(name + " must be above 0");
  (part == "pdelta" ? parameter.delta : parameter.scale) = *number;
}

std::optional<bool> fix_parameter(scene::Scene& scene, std::string_view name, bool fixed) {
  const language::Variable* const variable = scene.variables.find(name);
  if (variable == nullptr || !std::holds_alternative<double>(variable->value)) return std::nullopt;
  const language::VariableId id = *scene.variables.find_id(name);
  const auto parameter = std::find_if(scene.parameters.begin(), scene.parameters.end(),
                                      [&](const scene::FreeParameter& p) { return p.variable == id; });
  if (!fixed) refuse_in_periods(scene, id);
  if (parameter != scene.parameters.end()) return std::exchange(parameter->fixed, fixed) != fixed;
  if (!variable->parameter) return std::nullopt;
  if (fixed) return false;
  scene.parameters.push_back({.variable = id});
  return true;
}

}  // namespace lamella::session
