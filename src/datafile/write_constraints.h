// Level sets and boundaries, their declarations and the elements on them, as text.
#pragma once

#include <set>
#include <string>

#include "scene/scene.h"

namespace lamella::datafile {

// Declarations for the top section, after the parameters and attributes that their formulas read.
void write_constraints(std::string& out, const scene::Scene& scene);

// What the formulas of a scene read: it must be known before them.
std::set<language::VariableId> variables_of_formulas(const scene::Scene& scene);

// The words for what one kind of element is held by.
class ConstraintWriter {
 public:
  ConstraintWriter(const scene::Scene& scene, film::ElementKind kind);

  void write(std::string& out, std::uint32_t row) const;

 private:
  void write_constraints(std::string& out, std::uint32_t row) const;

  const scene::Scene& scene_;
  const film::Column* constraints_;
  const film::Column* boundaries_;
  bool orientation_;  // is written with the other attributes
};

}  // namespace lamella::datafile
