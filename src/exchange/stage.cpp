#include "exchange/stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella::exchange {

using film::Vec3;
using picture::LineKind;

namespace {

FilmPiece piece_of(const Mesh& mesh, const Part& part) {
  FilmPiece piece{{}, normals_of(mesh, part), part.triangles, part.regions};
  piece.points.reserve(part.points.size());
  for (const std::uint32_t p : part.points) piece.points.push_back(mesh.points[p]);
  return piece;
}

StageCamera camera_of(const picture::Framing& framing) {
  const picture::Camera& c = framing.camera;
  const double unit = framing.surrounding.radius;
  const auto& [right, up, back] = c.axes;
  StageCamera camera;
  camera.eye = framing.surrounding.middle + unit * (c.eye.x * right + c.eye.y * up + c.eye.z * back);
  camera.right = right;
  camera.up = up;
  camera.back = back;
  camera.height_angle = 2 * std::atan(1 / c.y_scale);
  camera.shift_right = c.x_shift / 2;
  camera.shift_up = c.y_shift / 2;
  camera.nearest = unit * c.nearest;
  camera.farthest = unit * c.farthest;
  return camera;
}

void add_lines(Stage& stage, const Mesh& mesh, const picture::Style& style) {
  struct Row {
    LineKind kind;
    std::string_view name;
    const picture::LineStyle* line;
  };
  const Row rows[] = {{LineKind::border, "borders", &style.border},
                      {LineKind::rim, "rims", &style.rim},
                      {LineKind::wire, "wires", &style.wire}};
  for (const Row& row : rows) {
    Solid solid = tubes_of(mesh, row.kind, row.line->radius * stage.radius);
    if (!solid.triangles.empty()) stage.lines.push_back({row.name, std::move(solid), row.line->colour});
  }
}

}  // namespace

Stage stage_of(const scene::Scene& scene, const picture::PictureOptions& picture) {
  const picture::Framing framing = picture::framing_of(scene, picture);
  const Mesh mesh = mesh_of(scene);
  Stage stage;
  stage.camera = camera_of(framing);
  stage.film_style = picture.style.film;
  stage.middle = framing.surrounding.middle;
  stage.radius = framing.surrounding.radius;
  for (const Part& part : films_of(mesh)) stage.films.push_back(piece_of(mesh, part));
  add_lines(stage, mesh, picture.style);
  stage.lowest = std::numeric_limits<double>::infinity();
  stage.highest = -stage.lowest;
  for (const Vec3& p : mesh.points) {
    stage.lowest = std::min(stage.lowest, p.z);
    stage.highest = std::max(stage.highest, p.z);
  }
  return stage;
}

}  // namespace lamella::exchange
