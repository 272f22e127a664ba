// Scenes for the renderer Mitsuba 3.
#pragma once

#include <string>
#include <vector>

#include "exchange/file_set.h"
#include "exchange/stage.h"

namespace lamella::exchange {

// NAME.xml with the meshes that it names beside it: NAME-films.ply, of thin dielectric, NAME-borders.ply,
// NAME-rims.ply and NAME-wires.ply. `size` is that of the picture in pixels.
std::vector<NamedFile> write_mitsuba(const Stage& stage, const std::string& path, std::array<int, 2> size);

}  // namespace lamella::exchange
