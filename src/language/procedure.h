// Commands kept under a name: `gogo := { r; g 5 }`.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lamella::language {

struct Block;

struct Procedure {
  std::string name;                   // as written
  std::string source;                 // the text between and including the braces, for saving and `list`
  std::shared_ptr<const Block> body;  // parsed once
};

// By lower-case name.
using Procedures = std::map<std::string, Procedure, std::less<>>;

}  // namespace lamella::language
