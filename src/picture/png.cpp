#include "picture/png.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <png.h>

#include "text/error.h"

namespace lamella::picture {

namespace {

// libpng reports an error by calling back and must not get control again; an exception through its
// frames leaves nothing of ours behind, and the writer below frees its state.
[[noreturn]] void refuse(png_structp, png_const_charp message) {
  throw text::Error(fmt::format("the picture cannot be encoded as PNG: {}", message));
}

void ignore_warning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush(png_structp) {}

class Writer {
 public:
  Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, ignore_warning)) {
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw text::Error("the picture cannot be encoded as PNG: libpng does not start");
    }
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png_, &info_); }

  std::string write(const Image& image) {
    std::string bytes;
    const bool opaque = std::all_of(image.pixels.begin(), image.pixels.end(),
                                    [](const Pixel& p) { return p.opacity == 255; });
    png_set_write_fn(png_, &bytes, append, flush);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    // Smooth gradients gain little from the slow levels.
    png_set_compression_level(png_, 4);
    png_write_info(png_, info_);
    if (opaque) png_set_filler(png_, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < image.height; ++y) {
      png_write_row(png_, reinterpret_cast<png_const_bytep>(&image.pixels[image.index(0, y)]));
    }
    png_write_end(png_, info_);
    return bytes;
  }

 private:
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

std::string encode_png(const Image& image) {
  static_assert(sizeof(Pixel) == 4);
  return Writer().write(image);
}

}  // namespace lamella::picture
