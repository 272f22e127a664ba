#include "picture/painter.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "picture/gl.h"
#include "picture/interference.h"
#include "picture/shaders.h"

namespace lamella::picture {

namespace {

constexpr GLuint lists_binding = 0;
constexpr GLuint counter_binding = 1;
constexpr GLuint fragments_binding = 2;
constexpr GLuint tints_binding = 3;

// For one tile: 128 MB. The buffer begins with room for a few films behind each pixel and grows when a tile
// shows more.
constexpr std::size_t most_fragments = std::size_t{1} << 23;
constexpr std::size_t first_fragments_a_pixel = 2;

// Triangles that are drawn or left out together, with the part of the picture that they cover.
struct Chunk {
  static constexpr std::size_t size = 2048;
  double left = -1;
  double right = 1;
  double bottom = -1;
  double top = 1;
};

// The part of the picture that a tile shows, in [-1, 1], y upward.
struct Window {
  double left;
  double right;
  double bottom;
  double top;

  explicit Window(const Tile& t)
      : left(2 * (t.x + t.right) / t.picture_width - 1),
        right(2 * (t.x + t.width + t.right) / t.picture_width - 1),
        bottom(1 - 2 * (t.y + t.height + t.down) / t.picture_height),
        top(1 - 2 * (t.y + t.down) / t.picture_height) {}

  bool meets(const Chunk& c) const {
    return c.left < right && c.right > left && c.bottom < top && c.top > bottom;
  }
};

// A buffer mapped for reading for as long as this lives.
template <class T>
class Mapped {
 public:
  Mapped() = default;
  Mapped(const Gl& gl, const GlObject& buffer, std::size_t count) : gl_(&gl), buffer_(buffer.name()) {
    gl.BindBuffer(GL_COPY_READ_BUFFER, buffer_);
    const auto bytes = static_cast<GLsizeiptr>(std::max<std::size_t>(count, 1) * sizeof(T));
    const void* data = gl.MapBufferRange(GL_COPY_READ_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (data == nullptr) throw std::bad_alloc();
    values_ = {static_cast<const T*>(data), count};
  }
  Mapped(Mapped&& other) noexcept { *this = std::move(other); }
  Mapped& operator=(Mapped&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(buffer_, other.buffer_);
    std::swap(values_, other.values_);
    return *this;
  }
  ~Mapped() {
    if (gl_ == nullptr) return;
    gl_->BindBuffer(GL_COPY_READ_BUFFER, buffer_);
    gl_->UnmapBuffer(GL_COPY_READ_BUFFER);
  }
  std::span<const T> values() const { return values_; }

 private:
  const Gl* gl_ = nullptr;
  GLuint buffer_ = 0;
  std::span<const T> values_;
};

}  // namespace

struct Painter::State {
  const Drawing& drawing;
  const Style& style;
  int tile_width;
  int tile_height;
  std::unique_ptr<GlContext> context = make_gl_context();
  Gl gl{*context};
  Program film_program;
  Program tube_program;
  Program mask_program;
  GlObject film_array = make_vertex_array(gl);
  GlObject tube_array = make_vertex_array(gl);
  GlObject positions = make_buffer(gl);
  GlObject normals = make_buffer(gl);
  GlObject bends = make_buffer(gl);
  GlObject thickness = make_buffer(gl);
  GlObject vertex_tints = make_buffer(gl);
  GlObject indices = make_buffer(gl);
  GlObject tubes = make_buffer(gl);
  GlObject tints = make_buffer(gl);
  GlObject lists = make_buffer(gl);
  GlObject counter = make_buffer(gl);
  GlObject fragments = make_buffer(gl);
  GlObject light = make_texture(gl, GL_RGBA32F, tile_width, tile_height);
  GlObject depth = make_texture(gl, GL_DEPTH_COMPONENT32F, tile_width, tile_height);
  GlObject mask = make_texture(gl, GL_R8UI, tile_width, tile_height);
  GlObject interference =
      make_texture(gl, GL_RGBA16F, interference_table().thicknesses, interference_table().cosines);
  GlObject framebuffer = make_framebuffer(gl);
  std::size_t capacity = 0;
  std::size_t most = 0;
  Camera camera;
  std::vector<Chunk> chunks;
  std::vector<float> opaque;
  Mapped<std::uint32_t> mapped_lists;
  Mapped<Fragment> mapped_fragments;

  State(const Drawing& d, const Style& s, int width, int height, const ShaderPair& film,
        const ShaderPair& tube, const ShaderPair& masking)
      : drawing(d),
        style(s),
        tile_width(width),
        tile_height(height),
        film_program(gl, film.vertex, film.fragment),
        tube_program(gl, tube.vertex, tube.fragment),
        mask_program(gl, masking.vertex, masking.fragment) {
    load_interference();
    load_films();
    load_tubes();
    make_target();
    make_lists();
    set_style(film_program);
    set_style(tube_program);
    set_film_style();
  }

  void load_interference() {
    const InterferenceTable& table = interference_table();
    std::vector<std::array<float, 4>> texels;
    texels.reserve(table.colours.size());
    for (const Colour& c : table.colours) texels.push_back({c.red, c.green, c.blue, 1});
    gl.BindTexture(GL_TEXTURE_2D, interference.name());
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, table.thicknesses, table.cosines, GL_RGBA, GL_FLOAT,
                     texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }

  template <class T>
  void load_attribute(GLuint location, GLint numbers, const GlObject& buffer, const std::vector<T>& values) {
    fill(gl, buffer, GL_ARRAY_BUFFER, std::span<const T>(values));
    gl.VertexAttribPointer(location, numbers, GL_FLOAT, GL_FALSE, sizeof(T), nullptr);
    gl.EnableVertexAttribArray(location);
  }

  void load_films() {
    gl.BindVertexArray(film_array.name());
    load_attribute(0, 3, positions, drawing.positions);
    load_attribute(1, 3, normals, drawing.normals);
    load_attribute(2, 1, bends, drawing.bends);
    load_attribute(3, 1, thickness, drawing.thickness);
    static_assert(sizeof(VertexTint) == 4 * sizeof(float));
    if (!drawing.vertex_tints.empty()) load_attribute(4, 4, vertex_tints, drawing.vertex_tints);
    fill(gl, indices, GL_ELEMENT_ARRAY_BUFFER,
         std::span<const std::array<std::uint32_t, 3>>(drawing.triangles));
    static_assert(sizeof(Tint) == 8 * sizeof(float));
    const std::vector<Tint> none(1);
    fill(gl, tints, GL_SHADER_STORAGE_BUFFER,
         std::span<const Tint>(drawing.tints.empty() ? none : drawing.tints));
  }

  void load_tubes() {
    gl.BindVertexArray(tube_array.name());
    fill(gl, tubes, GL_ARRAY_BUFFER, std::span<const Tube>(drawing.tubes));
    const auto attribute = [&](GLuint location, GLint count, std::size_t offset) {
      gl.VertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, sizeof(Tube),
                             reinterpret_cast<const void*>(offset));
      gl.VertexAttribDivisor(location, 1);
      gl.EnableVertexAttribArray(location);
    };
    attribute(0, 4, offsetof(Tube, from));
    attribute(1, 4, offsetof(Tube, to));
    attribute(2, 3, offsetof(Tube, colour));
  }

  void make_target() {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, light.name(), 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth.name(), 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::logic_error("the framebuffer is not complete");
    }
    gl.Enable(GL_DEPTH_TEST);
  }

  void allocate(const GlObject& buffer, std::size_t bytes) const {
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.name());
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_READ);
  }

  void make_lists() {
    GLint largest = 0;
    gl.GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    most = std::min(static_cast<std::size_t>(largest) / sizeof(Fragment), most_fragments);
    const auto pixels = static_cast<std::size_t>(tile_width) * static_cast<std::size_t>(tile_height);
    allocate(lists, pixels * sizeof(std::uint32_t));
    allocate(counter, sizeof(std::uint32_t));
    make_room(first_fragments_a_pixel * pixels);
  }

  void make_room(std::size_t wanted) {
    capacity = std::min(wanted, most);
    allocate(fragments, capacity * sizeof(Fragment));
  }

  void set_style(const Program& program) const {
    program.use();
    program.set("above", style.surroundings.above);
    program.set("level", style.surroundings.level);
    program.set("below", style.surroundings.below);
    program.set("haze", style.haze);
    program.set("background", mix(style.background_top, style.background_bottom, 0.5F));
  }

  void set_film_style() const {
    const FilmStyle& film = style.film;
    film_program.use();
    film_program.set("opacity", film.opacity);
    film_program.set("grazing", film.grazing);
    film_program.set("falloff", film.falloff);
    film_program.set("iridescence", film.iridescence);
    film_program.set("most_thick", interference_table().most_thick);
    film_program.set("faceted", film.faceted ? 1.0 : 0.0);
    film_program.set("vertex_tinted", drawing.vertex_tints.empty() ? 0.0 : 1.0);
    film_program.set("highlights", film.highlights);
    film_program.set("tint_opacity", film.tint_opacity);
    film_program.set("tinted", drawing.tints.empty() ? 0.0 : 1.0);
  }

  void set_camera(const Program& program, const Window& w) const {
    program.use();
    program.set("axes", camera.axes);
    program.set("eye", camera.eye);
    program.set("parallel", camera.parallel ? 1.0 : 0.0);
    program.set("depths", camera.nearest, camera.farthest);
    const double x = 2 / (w.right - w.left);
    const double y = 2 / (w.top - w.bottom);
    program.set("lens", camera.x_scale * x, camera.y_scale * y, (camera.x_shift - (w.right + w.left) / 2) * x,
                (camera.y_shift - (w.top + w.bottom) / 2) * y);
  }

  void find_chunks() {
    chunks.assign((drawing.triangles.size() + Chunk::size - 1) / Chunk::size, {2, -2, 2, -2});
    for (std::size_t t = 0; t < drawing.triangles.size(); ++t) {
      Chunk& chunk = chunks[t / Chunk::size];
      for (const std::uint32_t v : drawing.triangles[t]) {
        const Point& p = drawing.positions[v];
        const film::Vec3 at = camera.project({p[0], p[1], p[2]});
        chunk.left = std::min(chunk.left, at.x);
        chunk.right = std::max(chunk.right, at.x);
        chunk.bottom = std::min(chunk.bottom, at.y);
        chunk.top = std::max(chunk.top, at.y);
      }
    }
  }

  // Pixels that are not wanted get the nearest depth of all: nothing that comes later is worked on there.
  void draw_mask(const Tile& tile) const {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, mask.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, tile.width, tile.height, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                     tile.wanted.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    mask_program.use();
    gl.BindVertexArray(tube_array.name());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }

  void draw_tubes(const Window& window, const Tile& tile) const {
    gl.DepthMask(GL_TRUE);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!tile.wanted.empty()) draw_mask(tile);
    if (drawing.tubes.empty()) return;
    set_camera(tube_program, window);
    gl.BindVertexArray(tube_array.name());
    gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(drawing.tubes.size()));
  }

  // The number of fragments, which may be more than there was room for.
  std::size_t draw_films(const Window& window, int width) const {
    const std::uint32_t none = Fragment::end_of_list;
    const std::uint32_t zero = 0;
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, lists.name());
    gl.ClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, counter.name());
    gl.ClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, lists_binding, lists.name());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, counter_binding, counter.name());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, fragments_binding, fragments.name());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, tints_binding, tints.name());
    gl.DepthMask(GL_FALSE);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    set_camera(film_program, window);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, interference.name());
    film_program.set("row_length", static_cast<GLuint>(width));
    film_program.set("capacity", static_cast<GLuint>(capacity));
    gl.BindVertexArray(film_array.name());
    draw_chunks(window);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    return Mapped<std::uint32_t>(gl, counter, 1).values()[0];
  }

  // Neighbouring chunks in one call.
  void draw_chunks(const Window& window) const {
    std::size_t first = 0;
    while (first < chunks.size()) {
      std::size_t last = first;
      while (last < chunks.size() && window.meets(chunks[last])) ++last;
      if (last > first) {
        const std::size_t begin = first * Chunk::size;
        const std::size_t count = std::min(last * Chunk::size, drawing.triangles.size()) - begin;
        film_program.set("first_triangle", static_cast<GLuint>(begin));
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(begin * sizeof(drawing.triangles[0])));
      }
      first = last + 1;
    }
  }
};

Painter::Painter(const Drawing& drawing, const Style& style, int tile_width, int tile_height)
    : state_(std::make_unique<State>(drawing, style, tile_width, tile_height, film_shaders(), tube_shaders(),
                                     mask_shaders())) {}

Painter::~Painter() = default;

void Painter::look_through(const Camera& camera) {
  state_->camera = camera;
  state_->find_chunks();
}

bool Painter::paint(const Tile& tile, PaintedTile& painted) {
  State& s = *state_;
  s.mapped_lists = {};
  s.mapped_fragments = {};
  const Window window(tile);
  s.gl.Viewport(0, 0, tile.width, tile.height);
  s.draw_tubes(window, tile);
  std::size_t count = s.draw_films(window, tile.width);
  if (count > s.capacity) {
    if (count > s.most) return false;
    s.make_room(count + count / 4);
    count = s.draw_films(window, tile.width);
  }
  const std::size_t samples = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
  s.opaque.resize(4 * samples);
  if (!s.drawing.tubes.empty()) {
    s.gl.ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_FLOAT, s.opaque.data());
  }
  s.mapped_lists = Mapped<std::uint32_t>(s.gl, s.lists, samples);
  s.mapped_fragments = Mapped<Fragment>(s.gl, s.fragments, count);
  painted = {s.mapped_lists.values(), s.mapped_fragments.values(), s.opaque};
  return true;
}

}  // namespace lamella::picture
