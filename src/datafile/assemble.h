// The film and the bodies of a scene, from rows that have been checked.
#pragma once

#include <vector>

#include "datafile/reading.h"
#include "datafile/resolve.h"

namespace lamella::datafile {

// The region of each body of the file. Bodies are counted in the order of the file, or keep their numbers,
// with rows marked absent between them. Notes a number too large for that.
std::vector<film::Region> number_bodies(Reading& reading);

// Fills reading.scene: film, columns, bodies. Faces with more than three edges are cut around a centre: the
// mean of the corners. The centres follow the vertices of the file, edge after edge from each corner to the
// centre follows the edges, and the pieces follow the faces; the face's own number goes to the piece at its
// last edge.
void assemble(Reading& reading, const Resolved& resolved, const std::vector<film::Region>& body_regions,
              const std::vector<film::RegionPair>& face_regions);

}  // namespace lamella::datafile
