#include <array>

#include <GL/osmesa.h>

#include "picture/gl_context.h"
#include "text/error.h"

namespace lamella::picture {

namespace {

class OsMesaContext : public GlContext {
 public:
  OsMesaContext() {
    constexpr int wanted[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = OSMesaCreateContextAttribs(wanted, nullptr);
    if (context_ == nullptr) {
      throw text::Error("pictures need OpenGL 4.3, which the OSMesa library here does not offer",
                        "Mesa's llvmpipe driver does: on Debian, package libosmesa6");
    }
    if (OSMesaMakeCurrent(context_, canvas_.data(), GL_UNSIGNED_BYTE, side, side) == GL_FALSE) {
      OSMesaDestroyContext(context_);
      throw text::Error("the OSMesa library does not start");
    }
  }
  ~OsMesaContext() override {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(context_);
  }

  Function find(const char* name) const override { return OSMesaGetProcAddress(name); }

 private:
  static constexpr int side = 4;
  OSMesaContext context_ = nullptr;
  std::array<std::uint32_t, side * side> canvas_{};  // OSMesa insists on one
};

}  // namespace

std::unique_ptr<GlContext> make_gl_context() {
  return std::make_unique<OsMesaContext>();
}

}  // namespace lamella::picture

#ifdef __SANITIZE_ADDRESS__
// OSMesa keeps a few hundred bytes of each context that it has destroyed. The leak checker asks here what to
// forgive, and how, for every program that draws.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\n";
}
extern "C" const char* __lsan_default_options() {
  return "print_suppressions=0";
}
#endif
