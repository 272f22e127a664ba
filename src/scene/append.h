// A second scene put beside the first.
#pragma once

#include "scene/scene.h"

namespace lamella::scene {

// Adds the film, bodies, constraints, boundaries and quantities of `other` to a scene of the same session
// (variables have the same ids). Elements and bodies come after those that are there. A declaration of
// `other` takes the place of one of the same name, or of the same number where it has none; a named one whose
// number is taken gets another. Variables of `other` overwrite; settings of the scene stay. Throws
// text::Error for films of strings or of periodic space, and for attributes that differ in shape.
void append(Scene& scene, const Scene& other);

}  // namespace lamella::scene
