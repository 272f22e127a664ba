// Arithmetic of values with derivatives: how they carry through operations.
//
// A number T is a double, or Lanes: as many doubles as are worth evaluating side by side. First<T> is a
// number with its gradient, Jet (formula.h) a double with gradient and Hessian. Every operation is written
// once for each of the three shapes.
#pragma once

#include <cmath>

#include "language/formula.h"

namespace lamella::language {

inline Lanes operator-(const Lanes& a) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = -a[i];
  return r;
}
inline Lanes operator+(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = a[i] + b[i];
  return r;
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = a[i] - b[i];
  return r;
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = a[i] * b[i];
  return r;
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = a[i] / b[i];
  return r;
}

template <class T>
T number(double value) {
  if constexpr (std::is_same_v<T, double>) {
    return value;
  } else {
    T r;
    r.fill(value);
    return r;
  }
}

// Derivatives of a function of one number, and of two.
template <class T>
struct Slopes {
  T f{};
  T first{};
  T second{};
};
using UnaryDerivatives = Slopes<double>;

template <class T>
struct SlopesOfTwo {
  T f{};
  T a{};
  T b{};
  T aa{};
  T ab{};
  T bb{};
};
using SecondOrder = SlopesOfTwo<double>;

// --- f(a) for a function with these derivatives at a's value

template <class T>
T compose(const T&, const Slopes<T>& d) {
  return d.f;
}

template <class T>
First<T> compose(const First<T>& a, const Slopes<T>& d) {
  return {d.f, {d.first * a.gradient[0], d.first * a.gradient[1], d.first * a.gradient[2]}};
}

inline constexpr std::array<std::array<std::size_t, 2>, 6> hessian_axes{
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

inline Jet compose(const Jet& a, const UnaryDerivatives& d) {
  Jet r;
  r.value = d.f;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = d.first * a.gradient[i];
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = hessian_axes[k];
    r.hessian[k] = d.first * a.hessian[k] + d.second * a.gradient[i] * a.gradient[j];
  }
  return r;
}

// --- f(a, b)

template <class T>
T compose(const T&, const T&, const SlopesOfTwo<T>& d) {
  return d.f;
}

template <class T>
First<T> compose(const First<T>& a, const First<T>& b, const SlopesOfTwo<T>& d) {
  First<T> r;
  r.value = d.f;
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

// --- sums, for which the general rules would do needless work

template <class T>
T sum(const T& a, const T& b) {
  return a + b;
}
template <class T>
First<T> sum(const First<T>& a, const First<T>& b) {
  First<T> r;
  r.value = a.value + b.value;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = a.gradient[i] + b.gradient[i];
  return r;
}
inline Jet sum(const Jet& a, const Jet& b) {
  Jet r;
  r.value = a.value + b.value;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = a.gradient[i] + b.gradient[i];
  for (std::size_t k = 0; k < 6; ++k) r.hessian[k] = a.hessian[k] + b.hessian[k];
  return r;
}

template <class T>
T negative(const T& a) {
  return -a;
}
template <class T>
First<T> negative(const First<T>& a) {
  return {-a.value, {-a.gradient[0], -a.gradient[1], -a.gradient[2]}};
}
inline Jet negative(const Jet& a) {
  return compose(a, UnaryDerivatives{-a.value, -1, 0});
}

// --- the shapes

template <class Scalar>
struct NumberOf {
  using type = Scalar;
};
template <class T>
struct NumberOf<First<T>> {
  using type = T;
};
template <>
struct NumberOf<Jet> {
  using type = double;
};

template <class Scalar>
const auto& value_of(const Scalar& a) {
  if constexpr (std::is_same_v<Scalar, typename NumberOf<Scalar>::type>) {
    return a;
  } else {
    return a.value;
  }
}

template <class Scalar>
Scalar constant(double value) {
  using T = typename NumberOf<Scalar>::type;
  if constexpr (std::is_same_v<Scalar, T>) {
    return number<T>(value);
  } else {
    Scalar r{};
    r.value = number<T>(value);
    return r;
  }
}

// a^n for a whole number n, by squaring; of 0 with its own sign of infinity where n is negative.
template <class T>
T whole_power(T a, int n) {
  T result = number<T>(1);
  for (int rest = std::abs(n); rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = result * a;
    if (rest > 1) a = a * a;
  }
  return n < 0 ? number<T>(1) / result : result;
}

// --- a^n in each shape, with no derivative that it does not carry

template <class T>
T raised(const T& a, int n) {
  return n == 2 ? a * a : whole_power(a, n);
}

template <class T>
First<T> raised(const First<T>& a, int n) {
  if (n == 0) return {number<T>(1), {}};
  const T below = n == 2 ? a.value : whole_power(a.value, n - 1);
  const T f = n > 0 ? below * a.value : whole_power(a.value, n);
  return compose(a, Slopes<T>{f, number<T>(n) * below, {}});
}

inline Jet raised(const Jet& a, int n) {
  const double x = a.value;
  const double first = n == 0 ? 0 : n * whole_power(x, n - 1);
  const double second = n == 0 || n == 1 ? 0 : n * (n - 1) * whole_power(x, n - 2);
  return compose(a, UnaryDerivatives{whole_power(x, n), first, second});
}

}  // namespace lamella::language
