// What there is to know about a scene at rest: areas, volumes, energies, kept until the scene changes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace lamella::energy {

struct Measures {
  double area = 0;              // plain area of all facets, tensions not applied
  double energy = 0;            // energy/film_energy.h
  double length = 0;            // of all edges
  std::vector<double> volumes;  // of region r, volconst included; [0] is meaningless
};

Measures measure(const scene::Scene& scene);

// Measures once and answers from memory while the scene stays as it was, so that a loop over thousands of
// bodies costs one sweep.
class MeasureCache {
 public:
  const Measures& of(const scene::Scene& scene);

 private:
  struct Key {
    std::uint64_t connectivity = 0;
    std::uint64_t positions = 0;
    std::uint64_t facet_tension = 0;
    std::uint64_t edge_tension = 0;
    bool symmetric_content = false;
    bool gravity_on = false;
    double gravity = 0;
    // What formulas of constraints and quantities depend on; counted only where there are some.
    std::uint64_t variables = 0;
    double time = 0;
    std::uint64_t columns = 0;
    double moduli = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  // What of a body enters the energy and volumes.
  struct BodyKey {
    double density = 0;
    double offset = 0;
    std::optional<double> pressure;
    bool absent = false;
    friend bool operator==(const BodyKey&, const BodyKey&) = default;
  };
  static Key key_of(const scene::Scene& scene);
  bool holds(const scene::Scene& scene) const;

  std::optional<Measures> measures_;
  Key key_;
  std::vector<BodyKey> bodies_;
};

}  // namespace lamella::energy
