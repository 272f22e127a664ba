// The OpenGL functions in use, and its objects as values that free themselves.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include <GL/glcorearb.h>

#include "picture/camera.h"
#include "picture/colour.h"
#include "picture/gl_context.h"

namespace lamella::picture {

// clang-format off
#define LAMELLA_GL_FUNCTIONS(X)                                                                            \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDBUFFER, BindBuffer) X(BINDBUFFERBASE, BindBufferBase)                \
  X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDTEXTURE, BindTexture) X(BINDVERTEXARRAY, BindVertexArray)      \
  X(BUFFERDATA, BufferData) X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(CLEAR, Clear)              \
  X(CLEARBUFFERDATA, ClearBufferData) X(CLEARCOLOR, ClearColor) X(COLORMASK, ColorMask)                    \
  X(COMPILESHADER, CompileShader) X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader)            \
  X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers) X(DELETEPROGRAM, DeleteProgram)\
  X(DELETESHADER, DeleteShader) X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays)\
  X(DEPTHMASK, DepthMask) X(DEPTHFUNC, DepthFunc) X(DRAWARRAYS, DrawArrays) X(DRAWARRAYSINSTANCED, DrawArraysInstanced) X(DRAWELEMENTS, DrawElements)        \
  X(ENABLE, Enable) X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                                    \
  X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) X(GENBUFFERS, GenBuffers)                                  \
  X(GENFRAMEBUFFERS, GenFramebuffers) X(GENTEXTURES, GenTextures) X(GENVERTEXARRAYS, GenVertexArrays)      \
  X(GETERROR, GetError) X(GETINTEGERV, GetIntegerv) X(GETPROGRAMINFOLOG, GetProgramInfoLog)                \
  X(GETPROGRAMIV, GetProgramiv) X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv)          \
  X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) X(MAPBUFFERRANGE, MapBufferRange)  \
  X(MEMORYBARRIER, MemoryBarrier) X(PIXELSTOREI, PixelStorei) X(READPIXELS, ReadPixels) X(SHADERSOURCE, ShaderSource)                  \
  X(TEXPARAMETERI, TexParameteri) X(TEXSTORAGE2D, TexStorage2D) X(TEXSUBIMAGE2D, TexSubImage2D) X(UNIFORM1F, Uniform1f) X(UNIFORM1UI, Uniform1ui) X(UNIFORM2F, Uniform2f)  \
  X(UNIFORM3F, Uniform3f) X(UNIFORM4F, Uniform4f) X(UNIFORMMATRIX3FV, UniformMatrix3fv)                    \
  X(UNMAPBUFFER, UnmapBuffer) X(USEPROGRAM, UseProgram) X(VERTEXATTRIBDIVISOR, VertexAttribDivisor)        \
  X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)
// clang-format on

// The functions by their names without "gl".
struct Gl {
#define LAMELLA_GL_DECLARE(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
  LAMELLA_GL_FUNCTIONS(LAMELLA_GL_DECLARE)
#undef LAMELLA_GL_DECLARE

  explicit Gl(const GlContext& context);
};

// An OpenGL object: its number, freed by `Free`, which is one of Gl's functions.
class GlObject {
 public:
  using Free = void (*)(const Gl&, GLuint);

  GlObject() = default;
  GlObject(const Gl& gl, GLuint name, Free free) : gl_(&gl), name_(name), free_(free) {}
  GlObject(GlObject&& other) noexcept
      : gl_(other.gl_), name_(std::exchange(other.name_, 0)), free_(other.free_) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    std::swap(free_, other.free_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) free_(*gl_, name_);
  }
  GLuint name() const { return name_; }

 private:
  const Gl* gl_ = nullptr;
  GLuint name_ = 0;
  Free free_ = nullptr;
};

GlObject make_buffer(const Gl& gl);
GlObject make_vertex_array(const Gl& gl);
GlObject make_framebuffer(const Gl& gl);
GlObject make_texture(const Gl& gl, GLenum format, int width, int height);

// Fills a buffer, bound to target.
template <class T>
void fill(const Gl& gl, const GlObject& buffer, GLenum target, std::span<const T> data) {
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STATIC_DRAW);
}

// A linked pair of shaders. Uniforms are set by name while it is in use.
class Program {
 public:
  // A shader that does not compile is our own mistake: std::logic_error with the compiler's words.
  Program(const Gl& gl, const std::string& vertex_shader, const std::string& fragment_shader);

  void use() const { gl_.UseProgram(program_.name()); }
  void set(const char* name, float value) const { gl_.Uniform1f(location(name), value); }
  void set(const char* name, double value) const { set(name, static_cast<float>(value)); }
  void set(const char* name, GLuint value) const { gl_.Uniform1ui(location(name), value); }
  void set(const char* name, const Colour& c) const { gl_.Uniform3f(location(name), c.red, c.green, c.blue); }
  void set(const char* name, const film::Vec3& v) const;
  void set(const char* name, double x, double y) const;
  void set(const char* name, double x, double y, double z, double w) const;
  void set(const char* name, const Axes& rows) const;

 private:
  GLint location(const char* name) const { return gl_.GetUniformLocation(program_.name(), name); }

  const Gl& gl_;
  GlObject program_;
};

}  // namespace lamella::picture
