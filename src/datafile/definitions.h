// What the top section of a datafile defines: parameters, variables, attributes, procedures.
#pragma once

#include "datafile/reading.h"

namespace lamella::datafile {

// These take what follows `parameter` and `define`, which are taken already.
void read_parameter(Reading& reading, bool optimized);
void read_define(Reading& reading);

// Takes a function or procedure whose first word is taken, to its closing brace, and keeps it as it stands
// for whoever can run commands. Where no braces follow, it is an announcement, `procedure f();`.
void keep_procedure(Reading& reading, const language::Token& word);

}  // namespace lamella::datafile
