// Which body lies on which side of each face, and whether the bodies make sense.
#pragma once

#include <vector>

#include "datafile/reading.h"
#include "datafile/resolve.h"

namespace lamella::datafile {

// The regions of each face; body b of the file (counted from 0) is region `regions[b]`. Notes as mistakes: a
// side that two bodies claim, a face that is listed against its neighbours, a body of positive volume listed
// inside out. Warns of a face listed twice, and of a body that is not closed although its films go on at the
// gap: a boundary on a wire or rim is lawful.
std::vector<film::RegionPair> check_bodies(Reading& reading, const Resolved& resolved,
                                           const std::vector<film::Region>& regions);

}  // namespace lamella::datafile
