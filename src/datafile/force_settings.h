// Forces, wind and air of a film in motion, as saved files carry them: parameters named lamella_... with
// formulas as texts, which Evolver reads as plain strings.
#pragma once

#include <string>

#include "datafile/reading.h"

namespace lamella::datafile {

// Takes a parameter that is one of these. False if it is not. Throws text::Error where its text is wrong.
bool read_force_setting(Reading& reading, const language::Token& name, const std::string& text);

// After the parameters that the formulas use.
void write_forces(std::string& out, const scene::Forces& forces);

}  // namespace lamella::datafile
