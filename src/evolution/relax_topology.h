// To an equilibrium that soap films keep, by whatever changes of topology lead there.
#pragma once

#include "evolution/hyperbolic.h"
#include "evolution/relax.h"

namespace lamella::evolution {

// Relaxes; pops edges and points that no soap film keeps (surgery/pop.h), and relaxes on; and where the film
// would collapse, or gets stuck, it goes back and moves under heavy damping instead, films merging, pinching
// and swapping neighbours as they do in motion, until they rest or the topology has changed and settled.
// Rounds are bounded: what the report says is how the last relaxation ended. The scene's time and damping
// stay; where it had to move, its vertices are at rest and without masses afterwards, as if it had never
// moved. `on_events` may change the scene.
RelaxReport relax_with_topology(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor,
                                const OnEvents& on_events);

}  // namespace lamella::evolution
