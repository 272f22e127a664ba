// Pictures as PNG files.
#pragma once

#include <string>

#include "picture/image.h"

namespace lamella::picture {

// The bytes of a PNG file: 8 bits a channel, sRGB; the opacity is left out where every pixel is opaque.
// Throws text::Error where libpng refuses the image.
std::string encode_png(const Image& image);

}  // namespace lamella::picture
