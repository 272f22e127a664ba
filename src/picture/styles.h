// The looks that a picture may have, by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "picture/style.h"

namespace lamella::picture {

struct NamedStyle {
  std::string_view name;
  std::string_view summary;
  Style (*make)();
};

// film, glass, paper, wire, regions, flat
const std::vector<NamedStyle>& named_styles();
std::vector<std::string> style_names();

// Throws text::Error with a suggestion where there is no such style.
Style style_named(std::string_view name);

}  // namespace lamella::picture
