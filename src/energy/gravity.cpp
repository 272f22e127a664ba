#include "energy/gravity.h"

#include <algorithm>

namespace lamella::energy {

namespace {

// z-component of twice the vector area.
double double_shadow(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double square_sum(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.z * a.z + b.z * b.z + c.z * c.z + a.z * b.z + b.z * c.z + c.z * a.z;
}

}  // namespace

double height_integral(const Vec3& a, const Vec3& b, const Vec3& c) {
  return double_shadow(a, b, c) * square_sum(a, b, c) / 24;
}

std::array<Vec3, 3> height_integral_gradient(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double shadow = double_shadow(a, b, c) / 24;
  const double squares = square_sum(a, b, c) / 24;
  const double heights = a.z + b.z + c.z;
  return {Vec3{(b.y - c.y) * squares, (c.x - b.x) * squares, (a.z + heights) * shadow},
          Vec3{(c.y - a.y) * squares, (a.x - c.x) * squares, (b.z + heights) * shadow},
          Vec3{(a.y - b.y) * squares, (b.x - a.x) * squares, (c.z + heights) * shadow}};
}

// The integral is shadow * squares / 24: the first does not see heights, the second nothing else.
TriangleHessian height_integral_hessian(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<Vec3, 3> corner{a, b, c};
  const double shadow = double_shadow(a, b, c) / 24;
  const double squares = square_sum(a, b, c) / 24;
  const double heights = a.z + b.z + c.z;
  std::array<Vec3, 3> by_shadow;
  std::array<Vec3, 3> by_squares;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 opposite = corner[(i + 2) % 3] - corner[(i + 1) % 3];
    by_shadow[i] = Vec3{-opposite.y, opposite.x, 0} / 24;
    by_squares[i] = {0, 0, corner[i].z + heights};
  }
  TriangleHessian h;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      h[i][j] += outer(by_shadow[i], by_squares[j]) + outer(by_squares[i], by_shadow[j]);
      h[i][j].z.z += (i == j ? 2 : 1) * shadow;
    }
    const std::size_t next = (i + 1) % 3;
    const Mat3 turn = film::cross_matrix({0, 0, squares});
    h[i][next] -= turn;
    h[next][i] += turn;
  }
  return h;
}

std::vector<HeavyFacet> heavy_facets(const scene::Scene& scene) {
  std::vector<HeavyFacet> heavy;
  const bool any = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                               [](const scene::Body& body) { return body.density != 0 && !body.absent; });
  if (!any || !scene.gravity.on || scene.gravity.constant == 0) return heavy;
  const auto density = [&](film::Region r) { return r.outside() ? 0.0 : scene.body(r).density; };
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
    if (!scene.film.alive(film::Triangle(t))) continue;
    const film::RegionPair pair = scene.film.regions(film::Triangle(t));
    const double weight = (density(pair.behind) - density(pair.front)) * scene.gravity.constant;
    if (weight != 0) heavy.push_back({t, weight});
  }
  return heavy;
}

double gravity_energy(const scene::Scene& scene) {
  double energy = 0;
  for (const HeavyFacet& facet : heavy_facets(scene)) {
    const std::array<Vec3, 3> p = scene.film.points(film::Triangle(facet.triangle));
    energy += facet.weight * height_integral(p[0], p[1], p[2]);
  }
  return energy;
}

}  // namespace lamella::energy
