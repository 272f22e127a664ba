// One solver after another by its name, on the mesh as it is: for comparison, and for whoever knows better.
#pragma once

#include "evolution/relax.h"

namespace lamella::evolution {

enum class Minimiser : std::uint8_t { descent, conjugate, lbfgs, newton };

// Runs until the residual is below the tolerance. Descent by plain or conjugate gradients ends when a step
// promises a smaller gain than that, so that it may end early; the others have the residual of `relax`. No
// upkeep of the mesh. Motion is normal unless the options say otherwise; gradients know no kinds of motion.
RelaxReport relax_by(Minimiser method, scene::Scene& scene, const RelaxOptions& options,
                     scene::Monitor& monitor);

}  // namespace lamella::evolution
