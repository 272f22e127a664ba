#include "picture/page.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "picture/interference.h"
#include "picture/page_text.h"
#include "picture/unwrapped.h"

namespace lamella::picture {

namespace {

template <class T>
std::string packed(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::string colour_list(const Colour& c) {
  return fmt::format("[{:.4f},{:.4f},{:.4f}]", c.red, c.green, c.blue);
}

// All frames in the units of the first.
std::vector<Point> common_places(const std::vector<Point>& places, const Drawing& of, const Drawing& first) {
  std::vector<Point> result;
  result.reserve(places.size());
  for (const Point& p : places)
    result.push_back(first.place(of.middle + of.radius * film::Vec3{p[0], p[1], p[2]}));
  return result;
}

// The regions at a shaded vertex are those of its facets: films meet along lines, where each has vertices of
// its own.
std::vector<std::array<std::uint16_t, 2>> vertex_regions(const Drawing& drawing) {
  std::vector<std::array<std::uint16_t, 2>> result(drawing.positions.size());
  for (std::size_t t = 0; t < drawing.triangles.size(); ++t) {
    for (const std::uint32_t v : drawing.triangles[t]) {
      result[v] = {static_cast<std::uint16_t>(drawing.regions[t].front.index),
                   static_cast<std::uint16_t>(drawing.regions[t].behind.index)};
    }
  }
  return result;
}

// Two ends, a radius and a colour for each line.
std::vector<float> line_numbers(const Drawing& drawing, const Drawing& first) {
  std::vector<float> numbers;
  const auto scale = static_cast<float>(drawing.radius / first.radius);
  for (const Tube& tube : drawing.tubes) {
    const std::vector<Point> ends = common_places({tube.from, tube.to}, drawing, first);
    for (const Point& p : ends) numbers.insert(numbers.end(), p.begin(), p.end());
    numbers.insert(numbers.end(),
                   {scale * tube.radius, tube.colour.red, tube.colour.green, tube.colour.blue});
  }
  return numbers;
}

// A colour and its strength for each vertex; none where nothing is coloured.
std::vector<std::array<float, 4>> vertex_paint(const Drawing& d) {
  std::vector<std::array<float, 4>> paint;
  for (const VertexTint& t : d.vertex_tints)
    paint.push_back({t.colour.red, t.colour.green, t.colour.blue, t.strength});
  if (!paint.empty() || d.tints.empty()) return paint;
  paint.resize(d.positions.size());
  for (std::size_t t = 0; t < d.triangles.size(); ++t) {
    const Tint& tint = d.tints[t];
    for (const std::uint32_t v : d.triangles[t])
      paint[v] = {tint.front.red, tint.front.green, tint.front.blue, tint.front_strength};
  }
  return paint;
}

// The arrays of a frame. One that is as in the frame before is left out.
class FrameWriter {
 public:
  explicit FrameWriter(const Drawing& first) : first_(first) {}

  std::string write(const PageFrame& frame) {
    const Drawing& d = frame.drawing;
    text_ = fmt::format("{{time:{}", frame.time);
    put("positions", packed(common_places(d.positions, d, first_)));
    put("normals", packed(d.normals));
    put("thickness", packed(d.thickness));
    put("regions", packed(vertex_regions(d)));
    put("tints", packed(vertex_paint(d)));
    put("triangles", packed(d.triangles));
    put("lines", packed(line_numbers(d, first_)));
    return text_ + "}";
  }

 private:
  void put(const std::string& name, std::string data) {
    const auto [at, made] = before_.try_emplace(name);
    if (!made && at->second == data) return;
    text_ += fmt::format(",{}:\"{}\"", name, data);
    at->second = std::move(data);
  }

  const Drawing& first_;
  std::string text_;
  std::map<std::string, std::string> before_;
};

// The colours of a field from its low end to its high one, or null.
std::string field_text(const std::optional<ColourField>& field) {
  if (!field) return "null";
  constexpr int steps = 16;
  std::vector<std::string> colours;
  for (int i = 0; i <= steps; ++i)
    colours.push_back(colour_list(colour_of(field->map, static_cast<double>(i) / steps)));
  return fmt::format("{{low:{},high:{},colours:[{}]}}", field->low, field->high, fmt::join(colours, ","));
}

// The table of interference as bytes; 85 is 1.
std::string interference_text() {
  const InterferenceTable& table = interference_table();
  std::vector<std::uint8_t> bytes;
  for (const Colour& c : table.colours) {
    for (const float light : {c.red, c.green, c.blue, 3.0F})
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(light * 85 + 0.5F, 0.0F, 255.0F)));
  }
  return fmt::format("{{width:{},height:{},mostThick:{},bytes:\"{}\"}}", table.thicknesses, table.cosines,
                     table.most_thick, packed(bytes));
}

std::string style_text(const Page& page) {
  const FilmStyle& film = page.style.film;
  const Surroundings& around = page.style.surroundings;
  std::vector<std::string> bodies;
  for (std::uint32_t b = 1; b <= page.bodies; ++b)
    bodies.push_back(colour_list(region_colour(film::Region{b})));
  return fmt::format(
      "{{top:{},bottom:{},above:{},level:{},below:{},opacity:{},grazing:{},falloff:{},iridescence:{},"
      "tintOpacity:{},byRegion:{},bodies:[{}]}}",
      colour_list(page.style.background_top), colour_list(page.style.background_bottom),
      colour_list(around.above), colour_list(around.level), colour_list(around.below), film.opacity,
      film.grazing, film.falloff, film.iridescence, film.tint_opacity, film.by_region,
      fmt::join(bodies, ","));
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

void replace(std::string& text, std::string_view mark, const std::string& by) {
  const std::size_t at = text.find(mark);
  text.replace(at, mark.size(), by);
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      result += i + k < bytes.size() + 1 ? letters[(group >> (18 - 6 * k)) & 63U] : '=';
  }
  return result;
}

void add_frame(Page& page, const scene::Scene& scene, const PictureOptions& options) {
  if (scene.film.periodic()) {
    return unwrapped(scene, options, [&](const scene::Scene& plain, const PictureOptions& plain_options) {
      add_frame(page, plain, plain_options);
    });
  }
  const bool first = page.frames.empty();
  const Framing framing = options.framing && !first ? *options.framing : framing_of(scene, options);
  Content content = options.content;
  content.surrounding = framing.surrounding;
  page.frames.push_back({draw(scene, options.style, content), scene.time});
  page.bodies = std::max(page.bodies, static_cast<std::uint32_t>(scene.bodies.size()));
  if (!first) return;
  page.title = scene.name;
  page.style = options.style;
  page.camera = framing.camera;
  page.field = options.content.field;
}

std::string write_page(const Page& page) {
  const Drawing& first = page.frames.front().drawing;
  std::vector<std::string> frames;
  FrameWriter writer(first);
  for (const PageFrame& frame : page.frames) frames.push_back(writer.write(frame));
  const Axes& a = page.camera.axes;
  const std::string camera =
      fmt::format("{{axes:[{},{},{},{},{},{},{},{},{}],eye:[{},{},{}],slope:{}}}", a[0].x, a[0].y, a[0].z,
                  a[1].x, a[1].y, a[1].z, a[2].x, a[2].y, a[2].z, page.camera.eye.x, page.camera.eye.y,
                  page.camera.eye.z, 1 / page.camera.y_scale);
  const std::string name = std::filesystem::path(page.title).filename().string();
  std::string text(page_text());
  replace(text, "@title@", escaped(name.empty() ? "Lamella" : name));
  replace(text, "@camera@", camera);
  replace(text, "@style@", style_text(page));
  replace(text, "@field@", field_text(page.field));
  replace(text, "@field_title@", page.field ? escaped(page.field->title) : "");
  replace(text, "@rate@", fmt::format("{}", page.frames_per_second));
  replace(text, "@interference@", interference_text());
  replace(text, "@frames@", fmt::format("[{}]", fmt::join(frames, ",\n")));
  return text;
}

}  // namespace lamella::picture
