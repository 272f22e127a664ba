// glTF 2.0, binary (.glb).
#pragma once

#include <string>

#include "exchange/stage.h"

namespace lamella::exchange {

// One mesh for each film between borders, all of one material: a thin film of water in air that lets light
// through (KHR_materials_transmission, KHR_materials_iridescence; its thickness grows downwards, as in
// pictures). Borders, rims and wires are solid tubes. The camera is that of the view. Upward is y, as glTF
// has it: the root node turns the scene's z there.
std::string write_glb(const Stage& stage);

}  // namespace lamella::exchange
