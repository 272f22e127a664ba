// Reads datafiles: the .fe language of vertices, edges, faces and bodies.
#pragma once

#include <string>
#include <vector>

#include "language/variables.h"
#include "scene/scene.h"
#include "text/error.h"
#include "text/source.h"

namespace lamella::datafile {

struct ReadResult {
  scene::Scene scene;
  // Functions and procedures of the top section, as commands that declare them: to be run first.
  std::vector<text::Place> procedures;
  // The commands after `read`, for whoever can run them: the rest of the file, and where `read` stands in an
  // included file, the rest of that one first. To be run one after the other. Empty where the datafile has
  // none. The macros of the datafile are replaced in them if it says `keep_macros`, and are unknown there
  // otherwise.
  std::vector<text::Place> read_section;
  std::vector<text::Diagnostic> warnings;
};

// With `session`, names of variables keep the ids that they have there (language::Variables::restart_like).
// Throws text::Error with everything that is wrong with the file, in the order of the text, at most twenty
// mistakes and a line that counts the rest. Features of the language that are not supported are refused by
// name.
ReadResult read_datafile(const std::string& path, const language::Variables* session = nullptr);
// Included files are looked for beside the file that the source is named after.
ReadResult read_datafile(const text::SourcePointer& file, const language::Variables* session = nullptr);

}  // namespace lamella::datafile
