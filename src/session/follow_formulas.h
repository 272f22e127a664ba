// What formulas hold goes along when a command has changed what they say.
#pragma once

#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace lamella::session {

// Periods take their present values, and vertices, fixed ones too, go back to their constraints and
// boundaries. Throws text::Error where one cannot be put there, or the periods are none.
void follow_formulas(scene::Scene& scene);

// Of constraints and boundaries alone, and of these rows.
void follow_constraints(scene::Scene& scene, std::span<const std::uint32_t> vertices);

}  // namespace lamella::session
