// Periods that are formulas of the scene's variables: the cell of a periodic film changes with them.
#pragma once

#include "scene/scene.h"

namespace lamella::scene {

// Puts the periods to what their formulas say now, if the scene has any. Vertices stay where they are, and
// edges go as far around as before. Throws text::Error where the periods lie in a plane or one is not finite.
void renew_periods(Scene& scene);

// Whether one of the formulas reads a variable.
bool periods_read(const Scene& scene, language::VariableId variable);

// What `scene.periods` say now, unit vectors in the directions that space does not have. Throws text::Error
// as above.
std::array<film::Vec3, 3> present_periods(Scene& scene);

}  // namespace lamella::scene
