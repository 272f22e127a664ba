#include "solve/free_parameters.h"

#include <cmath>

namespace lamella::solve {

FreeParameters::FreeParameters(const scene::Scene& scene) {
  for (std::size_t row = 0; row < scene.parameters.size(); ++row) {
    const scene::FreeParameter& parameter = scene.parameters[row];
    const language::Variable* const variable = scene.variables.get(parameter.variable);
    const double* const value = variable != nullptr ? std::get_if<double>(&variable->value) : nullptr;
    if (parameter.fixed || value == nullptr) continue;
    rows_.push_back(row);
    variables_.push_back(parameter.variable);
    values_.push_back(*value);
    scales_.push_back(parameter.scale);
    deltas_.push_back(parameter.delta);
  }
  slopes_.resize(size());
}

void FreeParameters::set(energy::FilmEnergy& energy, std::size_t k, double value) {
  values_[k] = value;
  energy.set_variables({&variables_[k], 1}, {&value, 1});
}

void FreeParameters::set(energy::FilmEnergy& energy, std::span<const double> values) {
  values_.assign(values.begin(), values.end());
  energy.set_variables(variables_, values_);
}

void FreeParameters::set(energy::FilmEnergy& energy, std::span<const double> from, double times,
                         std::span<const double> way) {
  for (std::size_t k = 0; k < size(); ++k) values_[k] = from[k] + times * way[k];
  energy.set_variables(variables_, values_);
}

bool FreeParameters::differentiate(energy::FilmEnergy& energy, std::span<const Vec3> x) {
  held_ = energy.held_values().size();
  held_slopes_.assign(size() * held_, 0);
  bool ok = true;
  for (std::size_t k = 0; k < size(); ++k) {
    const double here = values_[k];
    slopes_[k] = 0;
    for (const double sign : {1.0, -1.0}) {
      set(energy, k, here + sign * deltas_[k]);
      moved_.assign(x.begin(), x.end());
      ok = energy.constraints().project(moved_) && ok;
      const double weight = sign / (2 * deltas_[k]);
      slopes_[k] += weight * energy.value(moved_);
      for (std::size_t i = 0; i < held_; ++i) held_slopes_[k * held_ + i] += weight * energy.held_values()[i];
    }
    set(energy, k, here);
    ok = ok && std::isfinite(slopes_[k]);
  }
  // Boundaries remember where their vertices were last.
  moved_.assign(x.begin(), x.end());
  return energy.constraints().project(moved_) && ok;
}

void FreeParameters::publish(scene::Scene& scene, std::span<const double> ways) const {
  for (std::size_t k = 0; k < size(); ++k) {
    scene::FreeParameter& parameter = scene.parameters[rows_[k]];
    scene.variables.set(parameter.variable, values_[k]);
    parameter.force = slopes_[k];
    if (k < ways.size()) parameter.velocity = -ways[k];
  }
}

}  // namespace lamella::solve
