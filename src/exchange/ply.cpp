#include "exchange/ply.h"

#include <fmt/format.h>

#include "exchange/bytes.h"
#include "picture/colour.h"

namespace lamella::exchange {

namespace {

constexpr std::string_view beginning =
    "ply\nformat binary_little_endian 1.0\ncomment made by Lamella: soap films\n";

void declare(std::string& header, const std::vector<Attribute>& attributes) {
  for (const Attribute& a : attributes) {
    for (int k = 0; k < a.width; ++k) {
      header += fmt::format("property {} {}{}\n", a.whole ? "int" : "double", a.name,
                            a.width > 1 ? fmt::format("_{}", k + 1) : "");
    }
  }
}

void append_row(std::string& bytes, const std::vector<Attribute>& attributes, std::size_t row) {
  for (const Attribute& a : attributes) {
    const auto width = static_cast<std::size_t>(a.width);
    for (std::size_t k = 0; k < width; ++k) {
      const double value = a.values[row * width + k];
      if (a.whole) {
        append(bytes, static_cast<std::int32_t>(value));
      } else {
        append(bytes, value);
      }
    }
  }
}

void append_triangle(std::string& bytes, const Triple& corners) {
  append(bytes, std::uint8_t{3});
  for (const std::uint32_t corner : corners) append(bytes, static_cast<std::int32_t>(corner));
}

const Attribute* colours_of(const Mesh& mesh) {
  for (const Attribute& a : mesh.of_triangles) {
    if (a.name == "color") return &a;
  }
  return nullptr;
}

void append_colour(std::string& bytes, double number) {
  const picture::Colour colour = picture::evolver_colour(static_cast<int>(number));
  for (const float light : {colour.red, colour.green, colour.blue}) append(bytes, picture::srgb_byte(light));
}

std::size_t count_edges(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Line& line : mesh.lines) count += line.points.size() - 1;
  return count;
}

void append_edges(std::string& bytes, const Mesh& mesh) {
  for (const Line& line : mesh.lines) {
    const int kind = line.kind == picture::LineKind::border ? 1 : line.kind == picture::LineKind::rim ? 2 : 3;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      append(bytes, static_cast<std::int32_t>(line.points[i - 1]));
      append(bytes, static_cast<std::int32_t>(line.points[i]));
      append(bytes, static_cast<std::uint8_t>(kind));
    }
  }
}

}  // namespace

std::string write_ply(const Mesh& mesh) {
  const Attribute* const colours = colours_of(mesh);
  std::string text(beginning);
  text += fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
                      mesh.points.size());
  declare(text, mesh.of_points);
  text += fmt::format(
      "element face {}\nproperty list uchar int vertex_indices\nproperty int front\nproperty int behind\n",
      mesh.triangles.size());
  if (colours != nullptr) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  declare(text, mesh.of_triangles);
  text += fmt::format(
      "element edge {}\nproperty int vertex1\nproperty int vertex2\nproperty uchar kind\nend_header\n",
      count_edges(mesh));
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) append(text, mesh.points[i][k]);
    append_row(text, mesh.of_points, i);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    append_triangle(text, mesh.triangles[i]);
    append(text, static_cast<std::int32_t>(mesh.regions[i].front.index));
    append(text, static_cast<std::int32_t>(mesh.regions[i].behind.index));
    if (colours != nullptr) append_colour(text, colours->values[i]);
    append_row(text, mesh.of_triangles, i);
  }
  append_edges(text, mesh);
  return text;
}

std::string write_ply(const std::vector<film::Vec3>& points, const std::vector<film::Vec3>& normals,
                      const std::vector<Triple>& triangles) {
  std::string text(beginning);
  text += fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
                      points.size());
  if (!normals.empty()) text += "property double nx\nproperty double ny\nproperty double nz\n";
  text +=
      fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", triangles.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) append(text, points[i][k]);
    for (int k = 0; k < 3 && !normals.empty(); ++k) append(text, normals[i][k]);
  }
  for (const Triple& t : triangles) append_triangle(text, t);
  return text;
}

}  // namespace lamella::exchange
