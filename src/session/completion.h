// What Tab offers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lamella::session {

class Session;

struct Completion {
  std::size_t begin = 0;                // the byte where the word begins that is being typed
  std::vector<std::string> candidates;  // sorted; all begin with that word, whatever its case
  bool files = false;                   // a file's name is expected: offer those
};

// `line` is the text before the cursor.
Completion complete(Session& session, std::string_view line);

}  // namespace lamella::session
