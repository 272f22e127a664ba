#include "exchange/gltf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "exchange/bytes.h"
#include "picture/png.h"

namespace lamella::exchange {

namespace {

using film::Vec3;

// Numbers that glTF gives to what it knows.
constexpr int float_component = 5126;
constexpr int unsigned_component = 5125;
constexpr int vertex_data = 34962;
constexpr int index_data = 34963;

class GlbWriter {
 public:
  explicit GlbWriter(const Stage& stage) : stage_(stage) {}

  std::string write() {
    for (std::size_t i = 0; i < stage_.films.size(); ++i) add_film(stage_.films[i], i + 1);
    for (std::size_t i = 0; i < stage_.lines.size(); ++i) add_lines(stage_.lines[i], i);
    add_camera();
    return packed(json());
  }

 private:
  // Returns the view's number.
  std::size_t view(std::string_view data, int target) {
    while (binary_.size() % 4 != 0) binary_ += '\0';
    views_.push_back(fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}{}}}", binary_.size(),
                                 data.size(), target != 0 ? fmt::format(",\"target\":{}", target) : ""));
    binary_ += data;
    return views_.size() - 1;
  }

  std::size_t vectors(const std::vector<Vec3>& values, bool bounds) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::array<float, 3> low{infinity, infinity, infinity};
    std::array<float, 3> high{-infinity, -infinity, -infinity};
    std::string data;
    for (const Vec3& v : values) {
      for (int k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(v[k]);
        append(data, x);
        low[static_cast<std::size_t>(k)] = std::min(low[static_cast<std::size_t>(k)], x);
        high[static_cast<std::size_t>(k)] = std::max(high[static_cast<std::size_t>(k)], x);
      }
    }
    const std::string range =
        bounds ? fmt::format(",\"min\":[{}],\"max\":[{}]", fmt::join(low, ","), fmt::join(high, ",")) : "";
    return accessor(view(data, vertex_data), float_component, values.size(), "VEC3", range);
  }

  // Across the texture of thickness, from the top of the scene to its bottom.
  std::size_t depths(const std::vector<Vec3>& points) {
    std::string data;
    const double height = stage_.highest - stage_.lowest;
    for (const Vec3& p : points) {
      const double depth = height > 0 ? (stage_.highest - p.z) / height : 0;
      append(data, static_cast<float>(std::sqrt(std::clamp(depth, 0.0, 1.0))));
      append(data, 0.5F);
    }
    return accessor(view(data, vertex_data), float_component, points.size(), "VEC2", "");
  }

  std::size_t indices(const std::vector<Triple>& triangles) {
    std::string data;
    for (const Triple& t : triangles) {
      for (const std::uint32_t corner : t) append(data, corner);
    }
    return accessor(view(data, index_data), unsigned_component, 3 * triangles.size(), "SCALAR", "");
  }

  std::size_t accessor(std::size_t view, int component, std::size_t count, std::string_view type,
                       const std::string& more) {
    accessors_.push_back(
        fmt::format("{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}", view,
                    component, count, type, more));
    return accessors_.size() - 1;
  }

  void add_node(const std::string& name, const std::string& rest) {
    nodes_.push_back(fmt::format("{{\"name\":\"{}\",{}}}", name, rest));
  }

  void add_mesh(const std::string& name, const std::string& attributes, std::size_t corners,
                std::size_t material) {
    meshes_.push_back(fmt::format(
        "{{\"name\":\"{}\",\"primitives\":[{{\"attributes\":{{{}}},\"indices\":{},\"material\":{}}}]}}", name,
        attributes, corners, material));
    add_node(name, fmt::format("\"mesh\":{}", meshes_.size() - 1));
  }

  void add_film(const FilmPiece& film, std::size_t number) {
    const std::string attributes =
        fmt::format("\"POSITION\":{},\"NORMAL\":{},\"TEXCOORD_0\":{}", vectors(film.points, true),
                    vectors(film.normals, false), depths(film.points));
    add_mesh(fmt::format("film {} of regions {} and {}", number, film.regions.front.index,
                         film.regions.behind.index),
             attributes, indices(film.triangles), 0);
  }

  void add_lines(const LineSolid& lines, std::size_t number) {
    const std::string attributes =
        fmt::format("\"POSITION\":{},\"NORMAL\":{}", vectors(lines.solid.points, true),
                    vectors(lines.solid.normals, false));
    add_mesh(std::string(lines.name), attributes, indices(lines.solid.triangles), number + 1);
  }

  void add_camera() {
    const StageCamera& c = stage_.camera;
    const double near = std::max(c.nearest / 10, 1e-4 * stage_.radius);
    camera_ =
        fmt::format("{{\"type\":\"perspective\",\"perspective\":{{\"yfov\":{},\"znear\":{},\"zfar\":{}}}}}",
                    c.height_angle, near, 10 * c.farthest);
    add_node("view", fmt::format("\"camera\":0,\"matrix\":[{},{},{},0,{},{},{},0,{},{},{},0,{},{},{},1]",
                                 c.right.x, c.right.y, c.right.z, c.up.x, c.up.y, c.up.z, c.back.x, c.back.y,
                                 c.back.z, c.eye.x, c.eye.y, c.eye.z));
  }

  // Green runs from none to all: the part of the thickness from least to most.
  std::size_t thickness_image() {
    constexpr int width = 256;
    picture::Image image(width, 2);
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < width; ++x) image.at(x, y) = {0, static_cast<std::uint8_t>(x), 0, 255};
    }
    return view(picture::encode_png(image), 0);
  }

  // The base lets everything through and reflects nothing: all that is seen is the layer upon it, water
  // between air and air.
  std::string film_material() const {
    return fmt::format(
        "{{\"name\":\"soap film\",\"doubleSided\":true,\"pbrMetallicRoughness\":{{\"metallicFactor\":0,"
        "\"roughnessFactor\":0.01}},\"extensions\":{{\"KHR_materials_transmission\":{{\"transmissionFactor\":"
        "1}},\"KHR_materials_ior\":{{\"ior\":1}},\"KHR_materials_iridescence\":{{\"iridescenceFactor\":1,"
        "\"iridescenceIor\":1.33,\"iridescenceThicknessMinimum\":{},\"iridescenceThicknessMaximum\":{},"
        "\"iridescenceThicknessTexture\":{{\"index\":0}}}}}}}}",
        stage_.film_style.thickness_top, stage_.film_style.thickness_bottom);
  }

  std::string line_material(const LineSolid& lines) const {
    return fmt::format(
        "{{\"name\":\"{}\",\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{:.4f},{:.4f},{:.4f},1],"
        "\"metallicFactor\":0.1,\"roughnessFactor\":0.35}}}}",
        lines.name, lines.colour.red, lines.colour.green, lines.colour.blue);
  }

  std::string json() {
    const std::size_t image = thickness_image();
    std::vector<std::string> materials = {film_material()};
    for (const LineSolid& lines : stage_.lines) materials.push_back(line_material(lines));
    std::vector<std::size_t> children;
    for (std::size_t i = 0; i < nodes_.size(); ++i) children.push_back(i);
    nodes_.push_back(
        fmt::format("{{\"name\":\"scene\",\"rotation\":[-0.70710678,0,0,0.70710678],\"children\":[{}]}}",
                    fmt::join(children, ",")));
    return fmt::format(
        "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"Lamella\"}},\"extensionsUsed\":["
        "\"KHR_materials_transmission\",\"KHR_materials_iridescence\",\"KHR_materials_ior\"],\"scene\":0,"
        "\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{}],\"cameras\":[{}],\"materials\":[{}],"
        "\"textures\":[{{\"sampler\":0,\"source\":0}}],\"samplers\":[{{\"wrapS\":33071,\"wrapT\":33071}}],"
        "\"images\":[{{\"bufferView\":{},\"mimeType\":\"image/"
        "png\"}}],\"accessors\":[{}],\"bufferViews\":[{}],"
        "\"buffers\":[{{\"byteLength\":{}}}]}}",
        nodes_.size() - 1, fmt::join(nodes_, ","), fmt::join(meshes_, ","), camera_,
        fmt::join(materials, ","), image, fmt::join(accessors_, ","), fmt::join(views_, ","), binary_.size());
  }

  std::string packed(std::string text) {
    while (text.size() % 4 != 0) text += ' ';
    while (binary_.size() % 4 != 0) binary_ += '\0';
    std::string file = "glTF";
    append(file, std::uint32_t{2});
    append(file, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary_.size()));
    append(file, static_cast<std::uint32_t>(text.size()));
    file += "JSON" + text;
    append(file, static_cast<std::uint32_t>(binary_.size()));
    file.append("BIN\0", 4);
    return file + binary_;
  }

  const Stage& stage_;
  std::string binary_;
  std::string camera_;
  std::vector<std::string> views_;
  std::vector<std::string> accessors_;
  std::vector<std::string> meshes_;
  std::vector<std::string> nodes_;
};

}  // namespace

std::string write_glb(const Stage& stage) {
  return GlbWriter(stage).write();
}

}  // namespace lamella::exchange
