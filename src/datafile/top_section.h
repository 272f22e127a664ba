// The top section of a datafile: settings, parameters, declarations of attributes, cosmetic words.
#pragma once

#include <string_view>

#include "datafile/reading.h"

namespace lamella::datafile {

// Reads up to the first list of elements, whose keyword is left to be taken, or to the end.
void read_top_section(Reading& reading);

// Whether a line of the top section begins with this word, supported or not, or the section ends with it.
bool begins_declaration(std::string_view word);

// To the next line that begins with such a word: the lines before it belong to what could not be read.
void skip_declaration(TokenSource& tokens);

}  // namespace lamella::datafile
