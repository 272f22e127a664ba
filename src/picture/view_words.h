// Views by name and in files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "picture/view.h"

namespace lamella::picture {

// front (from -y), back, left, right, top, bottom, corner
std::vector<std::string> view_names();
// Throws text::Error with a suggestion where there is no such view.
Rotation rotation_named(std::string_view name);

// Turned as the viewer sees it: by angles in degrees to the right, upward and counterclockwise.
Rotation turned(const Rotation& rotation, double right, double up, double roll);

// A view as a few lines of text, and back. Reading throws text::Error without a place.
std::string write_view(const View& view);
View read_view(std::string_view text);

}  // namespace lamella::picture
