#include "session/quantity_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "energy/quantity_sums.h"
#include "text/error.h"
#include "text/suggest.h"

namespace lamella::session {

namespace {

constexpr std::uint32_t first_quantity_row = 1000000;  // above all internal variables

scene::Quantity& quantity_of(scene::Scene& scene, language::InternalId id) {
  const std::size_t row = (id.row - first_quantity_row) / quantity_part_names.size();
  if (row < scene.quantities.size()) return scene.quantities[row];
  throw text::Error("this quantity is no more");
}

}  // namespace

std::optional<language::InternalId> find_quantity_part(const scene::Scene& scene, std::string_view name) {
  const std::string key = text::lower(name);
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto quantity = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                     [&](const scene::Quantity& q) { return q.name == key.substr(0, dot); });
  const auto part = std::find(quantity_part_names.begin(), quantity_part_names.end(), key.substr(dot + 1));
  if (quantity == scene.quantities.end() || part == quantity_part_names.end()) return std::nullopt;
  const auto row = static_cast<std::size_t>(quantity - scene.quantities.begin());
  return language::InternalId{first_quantity_row +
                              static_cast<std::uint32_t>(quantity_part_names.size() * row) +
                              static_cast<std::uint32_t>(part - quantity_part_names.begin())};
}

bool is_quantity_part(language::InternalId id) {
  return id.row >= first_quantity_row;
}

double quantity_part(const scene::Scene& scene, language::InternalId id) {
  const std::size_t row = (id.row - first_quantity_row) / quantity_part_names.size();
  if (row >= scene.quantities.size()) throw text::Error("this quantity is no more");
  const scene::Quantity& quantity = scene.quantities[row];
  switch ((id.row - first_quantity_row) % quantity_part_names.size()) {
    case 0:
      return energy::quantity_value(scene, row);
    case 1:
      return quantity.target;
    case 2:
      return quantity.pressure;
    default:
      return quantity.modulus;
  }
}

void set_quantity_part(scene::Scene& scene, language::InternalId id, const language::Value& value) {
  scene::Quantity& quantity = quantity_of(scene, id);
  const std::string_view part =
      quantity_part_names[(id.row - first_quantity_row) % quantity_part_names.size()];
  const double* const number = std::get_if<double>(&value);
  if (number == nullptr || !std::isfinite(*number))
    throw text::Error(fmt::format("{}.{} must be a finite number", quantity.name, part));
  if (part == "target") {
    quantity.target = *number;
    const std::string read = scene::target_variable(quantity.name);
    if (scene.variables.find(read) != nullptr) scene.variables.set(scene.variables.id(read), *number);
  } else if (part == "modulus") {
    quantity.modulus = *number;
  } else {
    throw text::Error(fmt::format("{}.{} follows from the film and cannot be set", quantity.name, part));
  }
}

}  // namespace lamella::session
