// Named quantities as text.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lamella::datafile {

// Declarations for the top section.
void write_quantities(std::string& out, const scene::Scene& scene);

// The names of the quantities that elements of one kind are marked with.
class MembershipWriter {
 public:
  MembershipWriter(const scene::Scene& scene, film::ElementKind kind);

  void write(std::string& out, std::uint32_t row) const;

 private:
  struct Mark {
    const film::Column* column;
    std::string name;
  };
  std::vector<Mark> marks_;
};

}  // namespace lamella::datafile
