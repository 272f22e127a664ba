// Writes scenes as datafiles.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lamella::datafile {

// A datafile from which `read_datafile` makes the same scene again, and from which Surface Evolver makes a
// surface of the same counts and areas. Numbers are the shortest that are read back exactly.
//
// Elements keep their order and their numbers (with `keep_originals` where those have gaps); removed elements
// are left out. Variables that are no parameters, procedures and `gravity off` stand as commands after
// `read`, so they come back when these are run. Settings that the language has no word for are carried by
// parameters named lamella_..., velocities, masses and moving targets by declared attributes. Columns that
// are neither declared nor part of the language are derived from the rest, and not written.
//
// Throws text::Error where a number of the film is not finite: such a file could not be read.
std::string write_datafile(const scene::Scene& scene);

}  // namespace lamella::datafile
