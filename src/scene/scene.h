// A scene: the film, and only what this scene adds to it.
//
// Copying a scene is cheap (films share their arrays until they are changed), so a copy is what `undo`
// returns to and what a failed command leaves behind.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "film/film.h"
#include "language/procedure.h"
#include "language/variables.h"
#include "scene/cells.h"
#include "scene/constraint.h"
#include "scene/forces.h"
#include "scene/free_parameter.h"
#include "scene/quantity.h"

namespace lamella::scene {

// A change of a target volume spread over time: linear from `from` at `begin` to `to` at `end` (times are
// total_time).
struct VolumeRamp {
  double from = 0;
  double to = 0;
  double begin = 0;
  double end = 0;
};

// A region with properties. Body b (row b-1 of Scene::bodies) is film::Region{b}. A region that surgery
// removes leaves its row, marked absent, so that the numbers of the others stand.
struct Body {
  std::uint32_t original = 0;            // its number in the datafile
  std::optional<double> target_volume;   // a fixed volume
  std::optional<VolumeRamp> ramp;        // a target on the move; target_volume is its present value
  std::optional<double> fixed_pressure;  // a prescribed pressure; excludes a target volume
  double pressure = 0;                   // the multiplier of the volume constraint when last solved for
  double density = 0;                    // mass per volume, for gravity
  int phase = 0;                         // of what is in it; decides tensions when a datafile is read
  double volume_offset = 0;              // added to the volume (the datafile's volconst)
  bool absent = false;

  bool fixed_volume() const { return target_volume.has_value() && !absent; }
};

// A line of the datafile's top section that only a picture cares about, kept for saving.
struct CosmeticLine {
  std::string keyword;
  std::string text;  // as written, without the keyword
};

struct Gravity {
  double constant = 1;  // acts along -z
  bool on = true;
};

// How each step of `g` (steepest descent) moves: by a line search, or by a scale that stays.
struct DescentScale {
  double value = 0.1;
  bool fixed = false;
  double limit = 1;
};

// How often pictures repeat the scene: an expression in the datafile's transform generators.
struct ViewTransforms {
  std::string expression;
  bool on = false;
};

struct Scene {
  film::Film film;
  std::vector<Body> bodies;
  film::Columns body_columns;  // user attributes of bodies
  language::Variables variables;
  language::Procedures procedures;
  LevelSets level_sets;
  Boundaries boundaries;
  std::vector<Quantity> quantities;
  std::vector<FreeParameter> parameters;
  StringModel strings;
  // Of the periods of a periodic film, row by row, if any of them names a variable (scene/periods.h).
  std::vector<language::Formula> periods;
  double gap_constant = 1;              // of the gap energy at convex constraints
  int edge_integral_order = 3;          // polynomials up to this degree are integrated exactly along edges
  double constraint_tolerance = 1e-12;  // values of level sets that files and splits may leave
  int facet_integral_order = 6;         // and over facets
  // The parameters of a vertex that splits an edge of a boundary are the mean of the ends' (the datafile's
  // interp_bdry_param), else those of the point near the middle.
  bool interpolate_parameters = false;
  Gravity gravity;
  DescentScale scale;
  bool conjugate_gradient = false;  // whether g goes by conjugate directions (conj_grad)
  bool hessian_normal = true;       // whether Newton's method moves vertices along normals only
  bool keep_volumes = true;         // vc on|off
  bool symmetric_content =
      false;           // how the volume of a body that is not closed is measured (energy/volume.h)
  double time = 0;     // total_time
  double damping = 0;  // 1/s, for evolve
  Forces forces;
  bool mass_of_area = false;  // vertices weigh what their present area does, instead of carrying their mass
  double mesh_fitness = 0;    // best that evolve has seen (evolution/motion.h); 0 if it has not moved
  double steps_unkept = 0;    // of evolve since the mesh was made fit
  double work = 0;            // done on the film by forces, less what damping took, since motion began
  std::string name;           // the datafile's path, empty for none
  std::string title;          // its first comment lines, kept for saving
  std::vector<CosmeticLine> cosmetics;
  ViewTransforms view_transforms;
  std::string read_section;  // the text after READ, without procedures and variables

  Body& body(film::Region r) { return bodies[r.index - 1]; }
  const Body& body(film::Region r) const { return bodies[r.index - 1]; }
  bool has_fixed_volume() const;
  bool empty() const { return film.vertex_rows() == 0; }
};

// What the datafile calls faces: facets, or cells of the string model.
std::uint32_t facet_count(const Scene& scene);

// Bodies that exist.
std::uint32_t body_count(const Scene& scene);

// The target volume of a body at a time: on its ramp if it has one. The body must have a target.
double target_at(const Body& body, double time);

// Moves targets that are on a ramp to their values at a time; ramps that have ended go.
void advance_targets(Scene& scene, double time);

// The constant of gravity that acts: 0 where gravity is off.
double present_gravity(const Scene& scene);

// The tension of a facet: 1 unless the film has a column "tension".
double tension(const Scene& scene, film::Triangle t);

}  // namespace lamella::scene
