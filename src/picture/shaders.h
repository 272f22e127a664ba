// The shaders, in GLSL 4.30.
#pragma once

#include <string>

namespace lamella::picture {

struct ShaderPair {
  std::string vertex;
  std::string fragment;
};

// Triangles of film. Each fragment goes into its pixel's list (Fragment in blending.h); nothing is drawn.
ShaderPair film_shaders();

// Tubes and balls, each a rectangle facing the viewer on which the true shape is found by a ray a pixel.
ShaderPair tube_shaders();

// One triangle over everything, of the nearest depth wherever the texture is 0.
ShaderPair mask_shaders();

}  // namespace lamella::picture
