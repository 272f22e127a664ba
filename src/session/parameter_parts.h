// Parameters that are, or may be, optimized, in expressions: NAME.fixed, NAME.pdelta, NAME.pscale,
// NAME.p_force, NAME.p_velocity.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "language/expression.h"
#include "language/variables.h"
#include "scene/scene.h"

namespace lamella::session {

inline constexpr std::array<std::string_view, 5> parameter_part_names = {"fixed", "pdelta", "pscale",
                                                                         "p_force", "p_velocity"};

// "height.pscale" and the like; nothing for other names.
std::optional<language::InternalId> find_parameter_part(const scene::Scene& scene, std::string_view name);
bool is_parameter_part(language::InternalId id);

// Both throw text::Error: a parameter that is gone, a part that cannot be set.
double parameter_part(const scene::Scene& scene, language::InternalId id);
void set_parameter_part(scene::Scene& scene, language::InternalId id, const language::Value& value);

// Sets whether the parameter of this name is optimized, and tells whether that changed. Nothing where there
// is no parameter of that name.
std::optional<bool> fix_parameter(scene::Scene& scene, std::string_view name, bool fixed);

}  // namespace lamella::session
