// The mesh of a film in motion kept fit: on a fixed mesh runs die of triangles that collapse within the film.
#pragma once

#include "scene/scene.h"

namespace lamella::evolution {

// Flips edges and moves vertices within their films towards the middle of their neighbours, at one moment of
// a motion, where the mesh is worse than wanted: around vertices whose stiffness over mass exceeds `limit`.
// Volumes are kept, velocities are taken along (interpolated where a vertex went). Total mass stays what it
// is and, where no vertex is fixed, so do momentum and angular momentum; energy does, too, unless the
// difference is large against the kinetic energy. The vertex columns "velocity" and "mass" must be there.
// False if the film could not be brought back to its volumes; then it is to be thrown away.
bool keep_mesh_in_motion(scene::Scene& scene, double limit);

}  // namespace lamella::evolution
