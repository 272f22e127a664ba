// The comment with which a datafile begins.
#pragma once

#include <string>
#include <string_view>

namespace lamella::datafile {

// The lines of the first comments, up to a blank line, without the signs that make them comments.
std::string title_of(std::string_view content);

// The same as comments of a datafile.
std::string title_comment(std::string_view title);

}  // namespace lamella::datafile
