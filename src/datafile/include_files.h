// Files that datafiles are made of.
#pragma once

#include <optional>
#include <string>

#include "text/source.h"

namespace lamella::datafile {

// The text of a file, without the mark that some editors put in front. Throws text::Error.
text::SourcePointer read_text(const std::string& path);

// The same for all names of a file; empty where there is none.
std::string canonical_path_of(const std::string& path);

// The path of a file that another includes by a name: beside that one, beside the datafile, or in the folders
// of EVOLVERPATH. Nothing if it is in none of them.
std::optional<std::string> find_included(const std::string& name, const std::string& including,
                                         const std::string& datafile);

}  // namespace lamella::datafile
