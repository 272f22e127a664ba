// Named quantities in expressions: NAME.value, NAME.target, NAME.pressure, NAME.modulus.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "language/expression.h"
#include "language/variables.h"
#include "scene/scene.h"

namespace lamella::session {

inline constexpr std::array<std::string_view, 4> quantity_part_names = {"value", "target", "pressure",
                                                                        "modulus"};

// "vol.value" and the like; nothing for other names.
std::optional<language::InternalId> find_quantity_part(const scene::Scene& scene, std::string_view name);
bool is_quantity_part(language::InternalId id);

// Both throw text::Error: a quantity that is gone, a part that cannot be set.
double quantity_part(const scene::Scene& scene, language::InternalId id);
void set_quantity_part(scene::Scene& scene, language::InternalId id, const language::Value& value);

}  // namespace lamella::session
