// Several files that belong together.
#pragma once

#include <string>
#include <vector>

namespace lamella::exchange {

struct NamedFile {
  std::string path;
  std::string content;
};

// Writes all of them or none: where one cannot be written, those before it that are new go again. Throws
// text::Error with the system's reason.
void write_files(const std::vector<NamedFile>& files);

}  // namespace lamella::exchange
