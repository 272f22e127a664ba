// Mass and velocity of the vertices, as columns of the film.
#pragma once

#include <span>
#include <vector>

#include "energy/sweep.h"
#include "film/film.h"

namespace lamella::evolution {

// The vertex masses: the column "mass" where it gives every vertex that has area a mass, else the areas in
// `lines`. A refined film has vertices without mass, so its mass is measured anew.
std::vector<double> carried_masses(const film::Film& film, std::span<const energy::VertexLine> lines);

// The column "velocity", or zeros.
std::vector<film::Vec3> velocities(const film::Film& film);

// Writes the column, adding it where the film has none.
void store_velocities(film::Film& film, std::span<const film::Vec3> velocities);

// Writes both columns, adding them where the film has none.
void store_motion(film::Film& film, std::span<const double> masses, std::span<const film::Vec3> velocities);

}  // namespace lamella::evolution
