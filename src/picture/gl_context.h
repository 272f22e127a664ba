// The one place where pictures meet a way to get OpenGL without a window.
#pragma once

#include <memory>

namespace lamella::picture {

// An OpenGL context of version 4.3 or later, core profile, with no framebuffer worth drawing to. It is the
// calling thread's current context from its making to its end; one at a time.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;

  using Function = void (*)();
  virtual Function find(const char* name) const = 0;
};

// Mesa's software renderer, in memory (osmesa_context.cpp). Throws text::Error where it offers too little.
std::unique_ptr<GlContext> make_gl_context();

}  // namespace lamella::picture
