// Scenes as files for other programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exchange/file_set.h"
#include "exchange/mesh.h"
#include "picture/show.h"
#include "scene/scene.h"

namespace lamella::exchange {

enum class Format : std::uint8_t { vtp, vtu, ply, obj, stl, glb, mitsuba, datafile };

// By a path's ending; text::Error with a suggestion for others.
Format format_of(const std::string& path);
// .vtp, .vtu, ...
std::vector<std::string> endings();

enum class Division : std::uint8_t {
  none,
  body,  // a file NAME-B.ext for each body B: its closed surface, seen from outside (stl, obj, ply)
};

struct ExportOptions {
  Division per = Division::none;
  picture::PictureOptions picture;  // view and style (glb, mitsuba); size (mitsuba)
};

struct Exported {
  std::vector<NamedFile> files;
  std::vector<std::string> warnings;
};

// The files of a scene, not yet written. Throws text::Error where there is nothing to write.
Exported export_scene(const scene::Scene& scene, const std::string& path, const ExportOptions& options);

}  // namespace lamella::exchange
