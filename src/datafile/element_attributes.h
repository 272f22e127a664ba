// What follows an element in its list: attributes of the language and of the user.
#pragma once

#include <cstdint>
#include <string_view>

#include "datafile/reading.h"
#include "datafile/row_reader.h"

namespace lamella::datafile {

// Reads to the line's end. Throws text::Error at the first attribute that is unknown or lacks its value.
void read_attributes(Reading& reading, RowReader& line, film::ElementKind kind, std::uint32_t row);

// Whether this kind of element has an attribute of this name, supported or not.
bool begins_attribute(Reading& reading, film::ElementKind kind, std::string_view word);
// Throws what is to be said of a word that is no attribute of this kind.
[[noreturn]] void refuse_attribute(Reading& reading, film::ElementKind kind, const language::Token& word);

// Whether a value begins here: anything but a word that is an attribute of some kind of element.
bool at_value(Reading& reading, RowReader& line);

}  // namespace lamella::datafile
