// How far two facets are from one another, and from meeting.
#pragma once

#include <array>

#include "film/film.h"

namespace lamella::surgery {

using Corners = std::array<film::Vec3, 3>;

// Two facets that have no corner in common and come near one another, and no more than the way between them.
struct FacetPair {
  film::Triangle a;
  film::Triangle b;
  double gap = 0;
};

double longest_side(const Corners& p);

// No more than the distance of two triangles, and cheaper: the largest gap between them along the line of
// their middles, their normals and the axes. At most 0 where none of these separates them.
double gap_at_least(const Corners& a, const Corners& b);

// The distance of two triangles that do not pass through one another.
double distance(const Corners& a, const Corners& b);

// For two facets that have one corner in common: by how much the edges of each may change without leaving its
// side of a plane through that corner. At most 0 where they are not on two sides of the plane tried.
std::array<double, 2> room_at_corner(const film::Film& film, film::Triangle a, film::Triangle b);

// For two that have an edge in common: the part of each one's altitude, times the distance of unit vectors
// along them, across the edge.
std::array<double, 2> room_at_edge(const film::Film& film, film::Triangle a, film::Triangle b, double part);

// Whether two triangles meet while their corners move from one place to the other at constant speeds. They do
// not cross at the start. Advances by what the distance allows; where it becomes next to nothing, or that
// takes too long, they are said to meet.
bool meet_on_the_way(const Corners& a_from, const Corners& a_to, const Corners& b_from, const Corners& b_to);

}  // namespace lamella::surgery
