// The mesh of a film in motion kept fit: on a fixed mesh runs die of triangles that collapse within the film.
#pragma once

#include "scene/scene.h"

namespace lamella::evolution {

// Flips edges and moves vertices within their films towards the middle of their neighbours, at one moment of
// a motion: volumes are kept, velocities are taken along (interpolated where a vertex went), total mass and,
// where no vertex is fixed, momentum stay what they are. The vertex columns "velocity" and "mass" must be
// there. False if the film could not be brought back to its volumes; then it is to be thrown away.
bool keep_mesh_in_motion(scene::Scene& scene);

}  // namespace lamella::evolution
