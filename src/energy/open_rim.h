// The volume of a body that its films do not close, such as a cap on a wire.
//
// The volume of a closed body is the same whatever formula measures it. For an open one the datafile's
// convention decides: the integral of z dx dy over the films (what lies between them and the plane z = 0), or
// with `symmetric_content` a third of the integral of x.n (the cone from the origin). The sweep sums cones
// from a point near the film; what differs is, by Stokes' theorem, an integral along the open rim, so only
// rim edges pay.
#pragma once

#include <span>
#include <vector>

#include "film/film.h"
#include "film/mat3.h"

namespace lamella::energy {

using film::Mat3;
using film::Vec3;

// An edge along which the films of a region have a boundary, walked in the direction that the region's
// outward films induce.
struct RimEdge {
  film::Region region;
  film::Vertex from;
  film::Vertex to;
  double times = 1;  // how often the boundary passes here
};

enum class OpenVolume { above_plane, cone_from_origin };

// All open rims of a film; empty if every region with a label on some film is closed.
std::vector<RimEdge> open_rims(const film::Film& film);

// What the edge adds to the volume of its region, when the sweep measured cones from `origin`.
double rim_volume(const Vec3& from, const Vec3& to, const Vec3& origin, OpenVolume convention);

// d(volume)/d(from) and d/d(to), on top of a sixth of the double area vectors around each vertex, which is
// the gradient of a closed body's volume.
struct RimGradient {
  Vec3 from;
  Vec3 to;
};
RimGradient rim_volume_gradient(const Vec3& from, const Vec3& to, const Vec3& origin, OpenVolume convention);

// Second derivatives of `rim_volume`, on top of the cones' from `origin` (energy/triangle_hessian.h).
struct RimHessian {
  Mat3 from_from;
  Mat3 from_to;  // d2/d(from)d(to)
  Mat3 to_to;
};
RimHessian rim_volume_hessian(const Vec3& from, const Vec3& to, const Vec3& origin, OpenVolume convention);

// Adds the share of all rims to volumes[r].
void add_rim_volumes(std::span<const RimEdge> rims, std::span<const Vec3> positions, const Vec3& origin,
                     OpenVolume convention, std::span<double> volumes);

}  // namespace lamella::energy
