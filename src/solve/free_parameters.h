// The parameters of a scene that are unknowns beside its vertices.
#pragma once

#include <span>
#include <vector>

#include "energy/film_energy.h"
#include "scene/scene.h"

namespace lamella::solve {

using film::Vec3;

// Their values, and how energy and held values (volumes, fixed quantities) depend on them: by central
// differences, for which vertices go where their constraints and boundaries go. Most scenes have none.
class FreeParameters {
 public:
  FreeParameters() = default;
  explicit FreeParameters(const scene::Scene& scene);

  bool empty() const { return rows_.empty(); }
  std::size_t size() const { return rows_.size(); }
  std::span<const double> values() const { return values_; }
  double scale(std::size_t k) const { return scales_[k]; }
  double delta(std::size_t k) const { return deltas_[k]; }

  // Gives them values, and the energy's formulas.
  void set(energy::FilmEnergy& energy, std::span<const double> values);
  void set(energy::FilmEnergy& energy, std::size_t k, double value);
  // values[k] + times * way[k] for all k.
  void set(energy::FilmEnergy& energy, std::span<const double> from, double times,
           std::span<const double> way);

  // Finds the slopes at x. False if vertices cannot follow, or a number is not finite.
  bool differentiate(energy::FilmEnergy& energy, std::span<const Vec3> x);
  // The derivative of the energy, and of the held value i.
  double slope(std::size_t k) const { return slopes_[k]; }
  double held_slope(std::size_t k, std::size_t i) const { return held_slopes_[k * held_ + i]; }

  // Writes values to the scene, with the slopes, and the ways along which they go down if there are any.
  void publish(scene::Scene& scene, std::span<const double> ways) const;

 private:
  std::vector<std::size_t> rows_;  // in the scene's list
  std::vector<language::VariableId> variables_;
  std::vector<double> values_;
  std::vector<double> scales_;
  std::vector<double> deltas_;
  std::size_t held_ = 0;
  std::vector<double> slopes_;
  std::vector<double> held_slopes_;
  std::vector<Vec3> moved_;
};

}  // namespace lamella::solve
