// Whether two scenes are the same, bit for bit.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lamella::test {

// What a datafile keeps: the film with its columns and numbers, bodies, settings, parameters, cosmetic lines.
// The first difference found in words, or nothing. Removed elements, and columns that are neither declared
// nor part of the language, do not count. Variables other than parameters and procedures come back by the
// commands after `read`, and do not count either.
std::string first_difference(const scene::Scene& a, const scene::Scene& b);

}  // namespace lamella::test
