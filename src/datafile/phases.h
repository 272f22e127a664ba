// Surface tensions by pairs of phases: the datafile's PHASEFILE, and the word `phase` of bodies and of the
// string model's faces.
#pragma once

#include "datafile/reading.h"

namespace lamella::datafile {

// `PHASEFILE "name"`: the file is looked for as included ones are. Its first line tells how many phases there
// are; of the others those count that begin with two numbers of phases, whose tension follows.
void read_phasefile(Reading& reading, const language::Token& word);

// Gives every facet between two bodies (in the string model: every edge between two faces) the tension of
// their phases, 1 where the file names none. Facets of one body alone keep theirs. After the film has been
// made.
void apply_phases(Reading& reading);

}  // namespace lamella::datafile
