// Points where more than three strings meet, resolved: the string model's popping.
#pragma once

#include "scene/scene.h"
#include "surgery/pop.h"

namespace lamella::surgery {

// Vertices of more than three strings that nothing holds.
std::vector<film::Vertex> crowded_string_vertices(const scene::Scene& scene);

// At each vertex the two strings that enclose the smallest angle are drawn off to a new vertex, and a new
// edge of a tenth of the shorter one's length joins it to the old; again while more than three are left.
// Cells keep their loops: those that passed between the two and the rest pass along the new edge.
PopReport pop_string_vertices(scene::Scene& scene, std::span<const film::Vertex> vertices);

}  // namespace lamella::surgery
