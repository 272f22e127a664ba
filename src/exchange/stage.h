// What programs that draw are told besides the mesh: lines as solids, a camera, lengths for light.
#pragma once

#include "exchange/parts.h"
#include "exchange/tubes.h"
#include "picture/show.h"

namespace lamella::exchange {

// A piece of film with points of its own, so that it is smooth within itself and has edges at its borders.
struct FilmPiece {
  std::vector<film::Vec3> points;
  std::vector<film::Vec3> normals;
  std::vector<Triple> triangles;
  film::RegionPair regions;
};

struct LineSolid {
  std::string_view name;
  Solid solid;
  picture::Colour colour;
};

// From where a scene is looked at, in its own coordinates.
struct StageCamera {
  film::Vec3 eye;
  film::Vec3 right;
  film::Vec3 up;
  film::Vec3 back;            // from the scene towards the viewer
  double height_angle = 0.5;  // radians, of the whole height
  double shift_right = 0;     // of the scene in the picture, in parts of its width
  double shift_up = 0;        // and of its height
  double nearest = 0;
  double farthest = 1;
};

struct Stage {
  std::vector<FilmPiece> films;
  std::vector<LineSolid> lines;  // borders, rims and wires, those that there are
  StageCamera camera;
  picture::FilmStyle film_style;
  film::Vec3 middle;
  double radius = 1;
  double lowest = 0;  // z, of all films
  double highest = 1;
};

// `picture` gives the view, the style's line widths and colours, the thickness of films.
Stage stage_of(const scene::Scene& scene, const picture::PictureOptions& picture);

}  // namespace lamella::exchange
