// What Surface Evolver says, where it is installed.
#pragma once

#include <string>

#include "film/vec3.h"
#include "scene/scene.h"

namespace lamella::test {

struct EvolverAnswer {
  std::string output;
  bool loaded = false;
  std::uint32_t vertices = 0;
  std::uint32_t edges = 0;
  std::uint32_t facets = 0;
  std::uint32_t bodies = 0;
  double area = 0;
  double energy = 0;
};

// Loads a datafile in Evolver, and asks for counts and area.
EvolverAnswer ask_evolver(const std::string& datafile_text);

}  // namespace lamella::test
