#include "exchange/mitsuba.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "exchange/ply.h"

namespace lamella::exchange {

namespace {

using film::Vec3;

std::string triple(const Vec3& v) {
  return fmt::format("{}, {}, {}", v.x, v.y, v.z);
}

// All films as one mesh; points are shared within each film only.
std::string films_ply(const Stage& stage) {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<Triple> triangles;
  for (const FilmPiece& film : stage.films) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), film.points.begin(), film.points.end());
    normals.insert(normals.end(), film.normals.begin(), film.normals.end());
    for (const Triple& t : film.triangles) triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return write_ply(points, normals, triangles);
}

std::string sensor(const Stage& stage, std::array<int, 2> size) {
  const StageCamera& c = stage.camera;
  return fmt::format(R"(  <sensor type="perspective">
    <string name="fov_axis" value="y"/>
    <float name="fov" value="{}"/>
    <float name="near_clip" value="{}"/>
    <float name="far_clip" value="{}"/>
    <float name="principal_point_offset_x" value="{}"/>
    <float name="principal_point_offset_y" value="{}"/>
    <transform name="to_world">
      <lookat origin="{}" target="{}" up="{}"/>
    </transform>
    <film type="hdrfilm">
      <integer name="width" value="{}"/>
      <integer name="height" value="{}"/>
    </film>
    <sampler type="multijitter"><integer name="sample_count" value="256"/></sampler>
  </sensor>
)",
                     c.height_angle * 180 / std::numbers::pi, std::max(c.nearest / 10, 1e-4 * stage.radius),
                     100 * c.farthest, c.shift_right, -c.shift_up, triple(c.eye),
                     triple(c.eye - stage.radius * c.back), triple(c.up), size[0], size[1]);
}

// A grey sky, and two bright windows that the films reflect.
std::string lights(const Stage& stage) {
  const StageCamera& c = stage.camera;
  std::string text = R"(  <emitter type="constant"><rgb name="radiance" value="0.55, 0.62, 0.72"/></emitter>
)";
  struct Window {
    Vec3 at;
    double half;
    double radiance;
  };
  const double r = stage.radius;
  const Window windows[] = {{-4.0 * c.right + 4.5 * c.up + 4 * c.back, 1.6, 14},
                            {6.0 * c.right + 0.8 * c.up + 4 * c.back, 1.0, 8}};
  for (const Window& window : windows) {
    text += fmt::format(R"(  <shape type="rectangle">
    <transform name="to_world"><scale value="{}"/><lookat origin="{}" target="{}" up="{}"/></transform>
    <emitter type="area"><rgb name="radiance" value="{}"/></emitter>
  </shape>
)",
                        window.half * r, triple(stage.middle + r * window.at), triple(stage.middle),
                        triple(c.up), window.radiance);
  }
  return text;
}

}  // namespace

std::vector<NamedFile> write_mitsuba(const Stage& stage, const std::string& path, std::array<int, 2> size) {
  const std::filesystem::path scene(path);
  std::vector<NamedFile> files;
  const auto beside = [&](std::string_view what) {
    return fmt::format("{}-{}.ply", scene.stem().string(), what);
  };
  const auto put = [&](std::string_view what, std::string content) {
    files.push_back({(scene.parent_path() / beside(what)).string(), std::move(content)});
  };
  std::string text = R"(<?xml version="1.0" encoding="utf-8"?>
<!-- Made by Lamella: soap films. Draw it with: mitsuba FILE.xml -->
<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="64"/></integrator>
)";
  text += sensor(stage, size) + lights(stage);
  text += fmt::format(R"(  <shape type="ply">
    <string name="filename" value="{}"/>
    <bsdf type="thindielectric">
      <float name="int_ior" value="1.33"/>
      <float name="ext_ior" value="1"/>
    </bsdf>
  </shape>
)",
                      beside("films"));
  put("films", films_ply(stage));
  for (const LineSolid& lines : stage.lines) {
    text += fmt::format(R"(  <shape type="ply">
    <string name="filename" value="{}"/>
    <bsdf type="roughplastic">
      <rgb name="diffuse_reflectance" value="{:.4f}, {:.4f}, {:.4f}"/>
      <float name="alpha" value="0.15"/>
    </bsdf>
  </shape>
)",
                        beside(lines.name), lines.colour.red, lines.colour.green, lines.colour.blue);
    put(lines.name, write_ply(lines.solid.points, lines.solid.normals, lines.solid.triangles));
  }
  files.push_back({path, text + "</scene>\n"});
  return files;
}

}  // namespace lamella::exchange
