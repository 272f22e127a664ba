// Elements and their constraints.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lamella::scene {

// The numbers of the constraints on an element, without zeros; for a vertex with those that are global.
std::vector<int> constraints_of(const Scene& scene, film::ElementKind kind, std::uint32_t row);
// Puts a constraint on an element (nothing happens if it is there), or takes it off.
void add_constraint(Scene& scene, film::ElementKind kind, std::uint32_t row, int number);
void remove_constraint(Scene& scene, film::ElementKind kind, std::uint32_t row, int number);
bool on_constraint(const Scene& scene, film::ElementKind kind, std::uint32_t row, int number);

// Makes room for so many constraints on each element of a kind, so that new ones can inherit them.
void reserve_constraints(Scene& scene, film::ElementKind kind, int width);
// How many there is room for.
int constraint_width(const Scene& scene, film::ElementKind kind);

// 0 for none.
int boundary_of(const Scene& scene, film::ElementKind kind, std::uint32_t row);
void set_boundary(Scene& scene, film::ElementKind kind, std::uint32_t row, int number);
// Makes the column of boundaries, so that new elements can inherit them.
void reserve_boundaries(Scene& scene, film::ElementKind kind);
std::array<double, 3> boundary_parameters(const Scene& scene, film::Vertex v);
void set_boundary_parameters(Scene& scene, film::Vertex v, const std::array<double, 3>& parameters);

// The position on a boundary of a vertex by its parameters.
film::Vec3 boundary_position(const Scene& scene, const Boundary& boundary,
                             const std::array<double, 3>& parameters);

// Gives formulas the present values of variables. To be called when variables may have changed.
void bind_formulas(Scene& scene);

// The value of a level set's formula at a vertex.
double level(const Scene& scene, const LevelSet& set, film::Vertex v);

// Puts every vertex of rows `first` and up on its boundary (near the point nearest to where it is, found from
// the parameters of the vertex ahead of it) and on its constraints. After splits and refinement, so that a
// refined circle is a circle.
void settle_vertices(Scene& scene, std::uint32_t first);

// Puts every vertex on its constraints from where it is; fixed ones stay, or go with their boundary. Returns
// false if one cannot be put there.
bool constrain_vertices(Scene& scene);

}  // namespace lamella::scene
