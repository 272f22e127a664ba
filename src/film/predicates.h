// Signs of determinants, never wrong: a filter in floating point decides nearly always, exact expansions the
// rest (after J. R. Shewchuk, Discrete & Computational Geometry 18, 1997).
#pragma once

#include "film/vec3.h"

namespace lamella::film {

// The sign (-1, 0, 1) of det(a - d, b - d, c - d): positive where d lies behind the triangle a, b, c, whose
// normal by the right-hand rule points away from it.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// The sign of the turn a, b, c seen against an axis (0 to 2): positive where it is counterclockwise.
int orientation_along(int axis, const Vec3& a, const Vec3& b, const Vec3& c);

// Whether a segment and a triangle have a point in common. Touching counts.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace lamella::film
