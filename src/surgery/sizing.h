// How long edges should be: a number at each vertex, kept with the film.
#pragma once

#include <functional>

#include "scene/scene.h"

namespace lamella::surgery {

// The vertex column that holds it; 0 where a vertex has none yet. New vertices take the mean of their
// neighbours'.
inline constexpr const char* size_column = "mesh_size";

// Sizes change over the film by no more than this part of the way.
inline constexpr double steepest_grading = 0.3;

// The size at a vertex, or the mean length of its edges where none is kept.
double size_of(const film::Film& film, film::Vertex v);
// Half-way along an edge.
double size_of(const film::Film& film, film::Edge e);

bool has_sizes(const film::Film& film);
// Gives vertices that have no size the mean length of edges around them: a film is of the size that it has.
void keep_sizes(film::Film& film);
// Sets the size of every vertex by a function, bounded from both sides and in its grading.
void set_sizes(film::Film& film, const std::function<double(film::Vertex)>& size, double least, double most);

// After every edge was halved: sizes are half of what they were. A film without sizes gets none.
void halve_sizes(film::Film& film);
// Vertices in rows from here on, and their neighbours, lose their sizes: they are measured anew when next
// kept.
void forget_sizes(film::Film& film, std::uint32_t first);

// A size for a film's curvature: facets turn from one to the next by about this angle (radians).
double size_for_curvature(const film::Film& film, film::Vertex v, double turn);

}  // namespace lamella::surgery
