// Potential energy of heavy bodies: density * G * height, integrated over the body.
#pragma once

#include <array>

#include "film/vec3.h"

namespace lamella::energy {

using film::Vec3;

// The integral of z^2/2 dx dy over a triangle: summed over a body's films with outward normals, it is the
// integral of z over the body (divergence theorem).
double height_integral(const Vec3& a, const Vec3& b, const Vec3& c);
std::array<Vec3, 3> height_integral_gradient(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace lamella::energy
