// The commands at the end of a saved datafile.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lamella::datafile {

// A number or a text in quotes, as an expression; empty for a number that is not finite.
std::string written_value(const language::Value& value);

// `read` and after it variables, procedures and `gravity off`; nothing if there are none.
void write_commands(std::string& out, const scene::Scene& scene);

}  // namespace lamella::datafile
