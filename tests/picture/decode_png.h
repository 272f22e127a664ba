// Reads PNG files back, by libpng's own simplified reader.
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <png.h>

#include "picture/image.h"

namespace lamella::picture {

struct Decoded {
  Image image;
  bool has_opacity = false;
};

inline Decoded decode_png(const std::string& bytes) {
  png_image reader{};
  reader.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&reader, bytes.data(), bytes.size()), 0) << reader.message;
  Decoded decoded;
  decoded.has_opacity = (reader.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  reader.format = PNG_FORMAT_RGBA;
  decoded.image = Image(static_cast<int>(reader.width), static_cast<int>(reader.height));
  EXPECT_NE(png_image_finish_read(&reader, nullptr, decoded.image.pixels.data(), 0, nullptr), 0)
      << reader.message;
  return decoded;
}

}  // namespace lamella::picture
