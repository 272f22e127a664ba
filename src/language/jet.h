// Arithmetic of jets: how values carry their derivatives through operations.
#pragma once

#include <cmath>

#include "language/formula.h"

namespace lamella::language {

// A value and its gradient.
struct FirstJet {
  double value = 0;
  std::array<double, 3> gradient{};
};

// f(a) for a function with these derivatives at a.value.
inline double compose(double, double f, double, double) {
  return f;
}

inline FirstJet compose(const FirstJet& a, double f, double d1, double) {
  return {f, {d1 * a.gradient[0], d1 * a.gradient[1], d1 * a.gradient[2]}};
}

inline constexpr std::array<std::array<std::size_t, 2>, 6> hessian_axes{
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

inline Jet compose(const Jet& a, double f, double d1, double d2) {
  Jet r;
  r.value = f;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = d1 * a.gradient[i];
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = hessian_axes[k];
    r.hessian[k] = d1 * a.hessian[k] + d2 * a.gradient[i] * a.gradient[j];
  }
  return r;
}

// f(a, b) for a function with these derivatives by its two arguments.
struct SecondOrder {
  double f = 0;
  double a = 0;
  double b = 0;
  double aa = 0;
  double ab = 0;
  double bb = 0;
};

inline double compose(double, double, const SecondOrder& d) {
  return d.f;
}

inline FirstJet compose(const FirstJet& a, const FirstJet& b, const SecondOrder& d) {
  FirstJet r{d.f, {}};
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = d.a * a.gradient[i] + d.b * b.gradient[i];
  return r;
}

inline Jet compose(const Jet& a, const Jet& b, const SecondOrder& d) {
  Jet r;
  r.value = d.f;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = d.a * a.gradient[i] + d.b * b.gradient[i];
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = hessian_axes[k];
    r.hessian[k] = d.a * a.hessian[k] + d.b * b.hessian[k] + d.aa * a.gradient[i] * a.gradient[j] +
                   d.ab * (a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i]) +
                   d.bb * b.gradient[i] * b.gradient[j];
  }
  return r;
}

inline double value_of(double a) {
  return a;
}
inline double value_of(const FirstJet& a) {
  return a.value;
}
inline double value_of(const Jet& a) {
  return a.value;
}

}  // namespace lamella::language
