// Motions of the film as a whole that its energy does not feel.
#pragma once

#include <span>
#include <vector>

#include "solve/hessian.h"

namespace lamella::solve {

// A film that nothing holds may drift and turn at no cost. Restricted to the directions of a basis, and on a
// mesh of finite size, such a motion has a small curvature of either sign: no mode of the film, but the mesh
// preferring one place to another. These fields are what a Newton step must not follow and a count of
// negative modes must not count.
//
// Each is a reduced vector, orthonormal in the mass of the Hessian. The motions tried are the six of each
// connected piece of the film; one counts if energy and volumes stay the same when the piece makes it, no
// fixed vertex moves, and the Hessian's curvature along it is small against that of a rough field. Films of
// more than a few pieces have none: their number would cost more than it is worth.
std::vector<std::vector<double>> rigid_motions(Problem& problem, const film::Film& film, const Basis& basis,
                                               const ConstrainedHessian& hessian, std::span<const Vec3> x);

}  // namespace lamella::solve
