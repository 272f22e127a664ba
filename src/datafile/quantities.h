// Named quantities and their methods, as the top section declares them.
#pragma once

#include "datafile/reading.h"

namespace lamella::datafile {

// These take what follows `quantity` and `method_instance`, which are taken already.
void read_quantity(Reading& reading, const language::Token& word);
void read_method_instance(Reading& reading, const language::Token& word);

// Whether a quantity or an instance has this name.
bool is_quantity_name(const Reading& reading, std::string_view name);

// The film's columns that mark the elements of quantities.
void add_memberships(Reading& reading);

}  // namespace lamella::datafile
