// What is wrong with a text, where, and what would be right.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "text/source.h"

namespace lamella::text {

enum class Severity { error, warning };

// A place that explains a diagnostic, such as where the comment opened.
struct Note {
  Place place;
  std::string message;
};

struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string message;  // what is wrong, lower case, no full stop
  std::string hint;     // what would be right; may be empty
  std::vector<Note> notes;
};

// file:line:col: error: message
//   the line
//      ^~~~
//   hint
// Ends with a newline. Control characters in the line are shown as '?', very long lines are cut
// around the place.
std::string render(const Diagnostic& diagnostic);
std::string render(const std::vector<Diagnostic>& diagnostics);

// Thrown for everything that a person can mend: bad text, a bad argument, a file that cannot be read.
class Error : public std::exception {
 public:
  explicit Error(std::string message, std::string hint = {});
  explicit Error(Place place, std::string message, std::string hint = {});
  explicit Error(Diagnostic diagnostic);
  explicit Error(std::vector<Diagnostic> diagnostics);

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  const char* what() const noexcept override { return rendered_.c_str(); }

  // The same error with this place where a diagnostic has none yet.
  Error placed_at(const Place& place) const;

 private:
  std::vector<Diagnostic> diagnostics_;
  std::string rendered_;
};

}  // namespace lamella::text
