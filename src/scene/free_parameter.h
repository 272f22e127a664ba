// Variables that are unknowns like coordinates: the datafile's optimizing_parameter.
#pragma once

#include "language/variables.h"

namespace lamella::scene {

// Formulas of constraints, boundaries and quantities read the variable; the film follows when it changes.
struct FreeParameter {
  language::VariableId variable;
  double delta = 1e-4;  // half the difference over which derivatives by it are taken
  double scale = 1;     // how far it moves for a force, where a coordinate moves by 1
  bool fixed = false;   // not optimized for now
  // When last solved for: the derivative of the energy by it, and what volumes leave of that, times scale.
  double force = 0;
  double velocity = 0;
};

}  // namespace lamella::scene
