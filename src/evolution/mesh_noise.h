// What moves a film's mesh and not the film.
#pragma once

#include "scene/scene.h"

namespace lamella::evolution {

// Nothing holds vertices within a film where they are: their motion along it goes on until edges are too long
// or too short, and much of it is noise that differs from vertex to vertex. Takes `part` of the speed with
// which the ends of an edge part or approach out of it, for one edge after the other: of edges whose ends lie
// inside films, and of borders. The ends act on each other along their edge, so that both momenta stay, and
// what moves as a rigid body is not slowed. Where energy is kept, the motion of each connected part of the
// film about that of a rigid body gets back what is lost. Needs the vertex columns "velocity" and "mass"; not
// for periodic films.
void damp_mesh_noise(scene::Scene& scene, double part, bool keeps_energy);

}  // namespace lamella::evolution
