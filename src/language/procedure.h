// Commands kept under a name: `gogo := { r; g 5 }`, `function real half(real a) { return a/2 }`.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella::language {

struct Block;

struct Procedure {
  std::string name;                   // as written
  std::string source;                 // the text between and including the braces, for saving and `list`
  std::shared_ptr<const Block> body;  // parsed once; null where only declared
  std::vector<std::string>
      parameters;              // as written, with their types: "real height"; the first local values of a run
  bool returns_value = false;  // a function
};

// By lower-case name.
using Procedures = std::map<std::string, Procedure, std::less<>>;

}  // namespace lamella::language
