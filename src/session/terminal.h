// The standard error output, where messages go.
#pragma once

#include <string_view>

namespace lamella::session {

// Whether messages may be coloured: a terminal that can, and nobody has set NO_COLOR.
bool colours_allowed(int descriptor);

// Writes messages as text::render makes them, the words `error:` and `warning:` coloured where that is
// allowed.
void write_error(std::string_view message);

}  // namespace lamella::session
