// The top section of a datafile: settings, parameters, declarations of attributes, cosmetic words.
#pragma once

#include <string_view>

#include "datafile/reading.h"

namespace lamella::datafile {

// Reads up to the first list of elements, whose keyword is left to be taken, or to the end.
void read_top_section(Reading& reading);

// Whether a line of the top section begins with this word, supported or not, or the section ends with it.
bool begins_declaration(std::string_view word);

}  // namespace lamella::datafile
