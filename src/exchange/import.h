// Scenes from meshes that other programs made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace lamella::exchange {

struct ImportOptions {
  std::optional<double> tolerance;    // points this near are one; a millionth of the diagonal unless given
  std::optional<std::string> labels;  // a file of two regions for each facet
  bool free_rims = false;             // else edges of one facet are fixed, as on a wire
};

struct Imported {
  scene::Scene scene;
  double tolerance = 0;
  std::size_t merged_points = 0;
  std::size_t dropped = 0;     // facets without area by their corners
  std::size_t duplicates = 0;  // facets that lay upon another one
  std::size_t fixed_edges = 0;
  bool found_regions = false;  // from the geometry, not from labels
  std::vector<std::string> warnings;
};

// Regions come from `labels`, from what an export wrote beside the facets, or from the geometry (cells.h).
// Each region that has a boundary becomes a body, to keep the volume that it has. Facets are turned so that
// the lower region is in front; those that bound none, to agree with their neighbours. Throws text::Error;
// then nothing has happened.
Imported import_scene(const std::string& path, const ImportOptions& options);

}  // namespace lamella::exchange
