// Named quantities: sums of integrals over elements, to be added to the energy, held fixed, or reported.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "film/column.h"
#include "language/formula.h"

namespace lamella::scene {

// What is taken of each element.
enum class Method : std::uint8_t {
  vertex_scalar_integral,  // a function at the vertex
  edge_length,
  density_edge_length,   // tension times length
  edge_scalar_integral,  // a function over the length
  edge_vector_integral,  // a field along the edge
  facet_area,
  density_facet_area,           // tension times area
  facet_volume,                 // z over the shadow of the facet
  facet_scalar_integral,        // a function over the area
  facet_vector_integral,        // a field through the facet
  facet_general_integral,       // a function of position and area vector
  gravity_method,               // z^2/2 over its shadow, times the difference of the bodies' densities
  mean_curvature_integral,      // of an edge: half its length times the angle by which the film turns there
  gauss_curvature_integral,     // of facets: their angles at the boundary, less pi for each edge of it
  star_gauss_curvature,         // of a vertex: 2 pi less the angles around it
  sq_mean_curvature,            // of a vertex: 3/4 F.F/A, F the gradient of the area A around it
  star_perp_sq_mean_curvature,  // 3/4 A (F.N/N.N)^2, N the gradient of volume; both within its constraints
};

struct MethodInstance {
  std::string name;  // lower case; empty where a quantity has it for itself
  Method method = Method::facet_area;
  double modulus = 1;
  std::string element_modulus;  // the attribute that multiplies it, or empty
  bool global = false;          // taken of every element of its kind
  language::Formula scalar;
  std::array<language::Formula, 3> field;
};

enum class QuantityRole : std::uint8_t { info_only, energy, fixed, conserved };

struct Quantity {
  std::string name;  // lower case
  QuantityRole role = QuantityRole::info_only;
  double modulus = 1;
  double target = 0;    // of a fixed one
  double constant = 0;  // added to the sum of its methods
  double pressure = 0;  // of a fixed one: its multiplier when last solved for
  std::vector<MethodInstance> methods;
};

film::ElementKind element_of(Method method);
// As datafiles call it.
std::string_view name_of(Method method);
// Nothing for a method that there is not.
const Method* method_named(std::string_view name);
// Whether turning an element over changes the sign.
bool is_oriented(Method method);

// The variable by which formulas read the target of a fixed quantity: NAME.target.
std::string target_variable(std::string_view name);

// The column that marks the elements which a quantity or an instance is taken of: integers, 0 for no. The
// parts of a cut element inherit it. Oriented methods count an element with "orientation" -1 turned over.
std::string membership_column(std::string_view name);

}  // namespace lamella::scene
