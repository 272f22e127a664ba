#include "picture/gl.h"

#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "text/error.h"

namespace lamella::picture {

Gl::Gl(const GlContext& context) {
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(context.find(name));
    if (function == nullptr) throw text::Error(fmt::format("the OpenGL library lacks the function {}", name));
  };
#define LAMELLA_GL_LOAD(TYPE, NAME) load(NAME, "gl" #NAME);
  LAMELLA_GL_FUNCTIONS(LAMELLA_GL_LOAD)
#undef LAMELLA_GL_LOAD
}

GlObject make_buffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteBuffers(1, &n); }};
}

GlObject make_vertex_array(const Gl& gl) {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteVertexArrays(1, &n); }};
}

GlObject make_framebuffer(const Gl& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteFramebuffers(1, &n); }};
}

GlObject make_texture(const Gl& gl, GLenum format, int width, int height) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  return {gl, name, [](const Gl& g, GLuint n) { g.DeleteTextures(1, &n); }};
}

namespace {

GlObject compile(const Gl& gl, GLenum stage, const std::string& source) {
  GlObject shader(gl, gl.CreateShader(stage), [](const Gl& g, GLuint n) { g.DeleteShader(n); });
  const char* text = source.c_str();
  gl.ShaderSource(shader.name(), 1, &text, nullptr);
  gl.CompileShader(shader.name());
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &ok);
  if (ok == GL_FALSE) {
    std::array<char, 4096> log{};
    gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::logic_error(fmt::format("shader does not compile:\n{}", log.data()));
  }
  return shader;
}

}  // namespace

Program::Program(const Gl& gl, const std::string& vertex_shader, const std::string& fragment_shader)
    : gl_(gl), program_(gl, gl.CreateProgram(), [](const Gl& g, GLuint n) { g.DeleteProgram(n); }) {
  const GlObject vertex = compile(gl, GL_VERTEX_SHADER, vertex_shader);
  const GlObject fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_shader);
  gl.AttachShader(program_.name(), vertex.name());
  gl.AttachShader(program_.name(), fragment.name());
  gl.LinkProgram(program_.name());
  GLint ok = GL_FALSE;
  gl.GetProgramiv(program_.name(), GL_LINK_STATUS, &ok);
  if (ok == GL_FALSE) {
    std::array<char, 4096> log{};
    gl.GetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::logic_error(fmt::format("shaders do not link:\n{}", log.data()));
  }
}

void Program::set(const char* name, const film::Vec3& v) const {
  gl_.Uniform3f(location(name), static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

void Program::set(const char* name, double x, double y) const {
  gl_.Uniform2f(location(name), static_cast<float>(x), static_cast<float>(y));
}

void Program::set(const char* name, double x, double y, double z, double w) const {
  gl_.Uniform4f(location(name), static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
                static_cast<float>(w));
}

void Program::set(const char* name, const Axes& rows) const {
  std::array<float, 9> matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) matrix[3 * i + static_cast<std::size_t>(k)] = static_cast<float>(rows[i][k]);
  }
  gl_.UniformMatrix3fv(location(name), 1, GL_TRUE, matrix.data());
}

}  // namespace lamella::picture
