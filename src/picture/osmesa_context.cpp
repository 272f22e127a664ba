#include <array>
#include <string>

#include <GL/osmesa.h>
#include <dlfcn.h>

#include "picture/gl_context.h"
#include "text/error.h"

namespace lamella::picture {

namespace {

// The library is loaded with the first picture: it brings a compiler with it that takes longer to load than a
// small film to relax. It is never unloaded.
class OsMesa {
 public:
  OsMesa() {
    find(create, "OSMesaCreateContextAttribs");
    find(destroy, "OSMesaDestroyContext");
    find(make_current, "OSMesaMakeCurrent");
    find(function, "OSMesaGetProcAddress");
  }

  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) function = nullptr;

 private:
  static void* open() {
    for (const char* const name : {"libOSMesa.so.8", "libOSMesa.so"}) {
      if (void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    }
    throw text::Error("pictures need the OSMesa library, which cannot be loaded: " + std::string(dlerror()),
                      "on Debian, install the package libosmesa6");
  }
  template <class Function>
  void find(Function& target, const char* name) {
    target = reinterpret_cast<Function>(dlsym(library_, name));
    if (target == nullptr)
      throw text::Error(std::string("the OSMesa library here has no ") + name,
                        "on Debian, install the package libosmesa6");
  }

  void* library_ = open();
};

const OsMesa& osmesa() {
  static const OsMesa library;
  return library;
}

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
    context_ = osmesa().create(wanted, nullptr);
    if (context_ == nullptr) {
      throw text::Error("pictures need OpenGL 4.3, which the OSMesa library here does not offer",
                        "Mesa's llvmpipe driver does: on Debian, package libosmesa6");
    }
    if (osmesa().make_current(context_, canvas_.data(), GL_UNSIGNED_BYTE, side, side) == GL_FALSE) {
      osmesa().destroy(context_);
      throw text::Error("the OSMesa library does not start");
    }
  }
  ~OsMesaContext() override {
    osmesa().make_current(nullptr, nullptr, 0, 0, 0);
    osmesa().destroy(context_);
  }

  Function find(const char* name) const override { return osmesa().function(name); }

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
