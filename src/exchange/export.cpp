#include "exchange/export.h"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "datafile/write.h"
#include "exchange/gltf.h"
#include "exchange/mitsuba.h"
#include "exchange/obj.h"
#include "exchange/ply.h"
#include "exchange/stl.h"
#include "exchange/vtk.h"
#include "text/error.h"
#include "text/suggest.h"

namespace lamella::exchange {

namespace {

namespace fs = std::filesystem;

struct Ending {
  std::string_view text;
  Format format;
};

constexpr Ending known[] = {{".vtp", Format::vtp},     {".vtu", Format::vtu},    {".ply", Format::ply},
                            {".obj", Format::obj},     {".stl", Format::stl},    {".glb", Format::glb},
                            {".xml", Format::mitsuba}, {".fe", Format::datafile}};

Mesh whole_mesh(const scene::Scene& scene) {
  Mesh mesh = mesh_of(scene);
  if (mesh.triangles.empty() && mesh.lines.empty())
    throw text::Error("there is nothing to export: the scene has no facet and no wire");
  return mesh;
}

std::string write_part(const Mesh& mesh, const Part& part, Format format) {
  if (format == Format::stl) return write_stl(mesh, part);
  if (format == Format::obj) return write_obj(mesh, part);
  std::vector<film::Vec3> points;
  for (const std::uint32_t p : part.points) points.push_back(mesh.points[p]);
  return write_ply(points, {}, part.triangles);
}

Exported export_bodies(const Mesh& mesh, const fs::path& path, Format format) {
  if (format != Format::stl && format != Format::obj && format != Format::ply) {
    throw text::Error(fmt::format("bodies are not written as {} files each", path.extension().string()),
                      "per=body is for .stl, .obj and .ply; other formats tell regions apart in one file");
  }
  Exported exported;
  for (const Part& part : bodies_of(mesh)) {
    const std::uint32_t body = part.regions.behind.index;
    const std::string name = fmt::format("{}-{}{}", path.stem().string(), body, path.extension().string());
    exported.files.push_back({(path.parent_path() / name).string(), write_part(mesh, part, format)});
    if (!part.closed) exported.warnings.push_back(fmt::format("the surface of body {} is not closed", body));
  }
  if (exported.files.empty()) throw text::Error("there is no body to export");
  return exported;
}

std::string write_mesh(const Mesh& mesh, Format format) {
  switch (format) {
    case Format::vtp:
      return write_vtp(mesh);
    case Format::vtu:
      return write_vtu(mesh);
    case Format::ply:
      return write_ply(mesh);
    case Format::obj:
      return write_obj(mesh);
    default:
      return write_stl(mesh);
  }
}

}  // namespace

Format format_of(const std::string& path) {
  const std::string ending = text::lower(fs::path(path).extension().string());
  for (const Ending& each : known) {
    if (ending == each.text) return each.format;
  }
  const std::string near = text::did_you_mean(ending, endings());
  throw text::Error(ending.empty() ? "the ending of the file's name tells the format, and there is none"
                                   : fmt::format("no format is known as \"{}\"", ending),
                    near.empty() ? fmt::format("known are {}", fmt::join(endings(), ", ")) : near);
}

std::vector<std::string> endings() {
  std::vector<std::string> result;
  for (const Ending& each : known) result.emplace_back(each.text);
  return result;
}

Exported export_scene(const scene::Scene& scene, const std::string& path, const ExportOptions& options) {
  const Format format = format_of(path);
  if (options.per == Division::body) return export_bodies(whole_mesh(scene), path, format);
  if (format == Format::datafile) return {{{path, datafile::write_datafile(scene)}}, {}};
  if (format == Format::glb) return {{{path, write_glb(stage_of(scene, options.picture))}}, {}};
  if (format == Format::mitsuba) {
    return {write_mitsuba(stage_of(scene, options.picture), path,
                          {options.picture.width, options.picture.height}),
            {}};
  }
  return {{{path, write_mesh(whole_mesh(scene), format)}}, {}};
}

}  // namespace lamella::exchange
