// Potential energy of heavy bodies: density * G * height, integrated over the body.
#pragma once

#include <array>

#include "energy/triangle_hessian.h"
#include "scene/scene.h"

namespace lamella::energy {

using film::Vec3;

// The integral of z^2/2 dx dy over a triangle: summed over a body's films with outward normals, it is the
// integral of z over the body (divergence theorem).
double height_integral(const Vec3& a, const Vec3& b, const Vec3& c);
std::array<Vec3, 3> height_integral_gradient(const Vec3& a, const Vec3& b, const Vec3& c);
TriangleHessian height_integral_hessian(const Vec3& a, const Vec3& b, const Vec3& c);

// A facet between bodies of different density, with (density behind - density in front) * G.
struct HeavyFacet {
  std::uint32_t triangle = 0;
  double weight = 0;
};
// Empty where gravity is off or nothing has a density.
std::vector<HeavyFacet> heavy_facets(const scene::Scene& scene);

// The potential energy of a scene's heavy bodies.
double gravity_energy(const scene::Scene& scene);

}  // namespace lamella::energy
