#include "exchange/stl.h"

#include "exchange/bytes.h"

namespace lamella::exchange {

namespace {

using film::Vec3;

void append_point(std::string& bytes, const Vec3& p) {
  for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>(p[k]));
}

std::string header(std::size_t triangles) {
  constexpr std::size_t length = 80;
  std::string bytes = "made by Lamella: soap films";  // must not begin with "solid"
  bytes.resize(length, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles));
  return bytes;
}

void append_triangle(std::string& bytes, const std::array<Vec3, 3>& corners) {
  append_point(bytes, unit(cross(corners[1] - corners[0], corners[2] - corners[0])));
  for (const Vec3& corner : corners) append_point(bytes, corner);
  append(bytes, std::uint16_t{0});
}

}  // namespace

std::string write_stl(const Mesh& mesh) {
  std::string bytes = header(mesh.triangles.size());
  for (const Triple& t : mesh.triangles)
    append_triangle(bytes, {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  return bytes;
}

std::string write_stl(const Mesh& mesh, const Part& part) {
  std::string bytes = header(part.triangles.size());
  const auto at = [&](std::uint32_t p) { return mesh.points[part.points[p]]; };
  for (const Triple& t : part.triangles) append_triangle(bytes, {at(t[0]), at(t[1]), at(t[2])});
  return bytes;
}

}  // namespace lamella::exchange
