// Vertices go back to their constraints and boundaries when a command has moved either.
#pragma once

#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace lamella::session {

// Fixed ones too. Throws text::Error where one cannot be put there.
void follow_constraints(scene::Scene& scene);
// Of these rows alone.
void follow_constraints(scene::Scene& scene, std::span<const std::uint32_t> vertices);

}  // namespace lamella::session
