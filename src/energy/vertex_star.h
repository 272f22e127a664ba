// Curvature at a vertex, from the triangles around it.
#pragma once

#include <span>
#include <vector>

#include "film/film.h"
#include "film/mat3.h"
#include "film/unfolding.h"

namespace lamella::energy {

using film::Mat3;
using film::Vec3;

// The triangles around a vertex, which is the first corner of each, so oriented that they agree with the
// first of them as far as that can be.
struct VertexStar {
  std::uint32_t vertex = 0;
  std::vector<std::array<std::uint32_t, 3>>
      triangles;  // their corners: rows of the unfolding, if there is one
  // Orthonormal directions that are taken out of gradients at the vertex: mirrors that the film continues
  // behind.
  std::vector<Vec3> mirrors;
};

VertexStar star_of(const film::Film& film, const film::Unfolding& unfolding, film::Vertex v);

// The rows of the star's vertices, its own first.
std::vector<std::uint32_t> rows_of(const VertexStar& star);

struct StarValue {
  double value = 0;
  Vec3 at_vertex;                                // derivatives by the vertex
  std::vector<std::array<Vec3, 2>> at_others{};  // and by the other corners, triangle by triangle
};

// 3/4 F.F/A: F the gradient by the vertex of the area A of its triangles.
StarValue squared_curvature(const VertexStar& star, std::span<const Vec3> positions);
// 3/4 A (F.N/N.N)^2: N the gradient of the volume under the triangles.
StarValue perpendicular_squared_curvature(const VertexStar& star, std::span<const Vec3> positions);

// Where second derivatives go: d2/d(u)d(v), once for each pair of vertices in whatever order, and for u = v.
class HessianSink {
 public:
  virtual ~HessianSink() = default;
  virtual void add(std::uint32_t u, std::uint32_t v, const Mat3& block) = 0;
};

// Adds `factor` times their second derivatives.
void add_squared_curvature_hessian(const VertexStar& star, std::span<const Vec3> positions, double factor,
                                   HessianSink& sink);
void add_perpendicular_squared_curvature_hessian(const VertexStar& star, std::span<const Vec3> positions,
                                                 double factor, HessianSink& sink);

}  // namespace lamella::energy
