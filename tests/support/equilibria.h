// Films near equilibria that theory knows, for tests.
#pragma once

#include "support/shapes.h"

namespace lamella::test {

// A film between two fixed rings of radius 1 at z = +-half, along a meridian of the given radius there;
// `along` and `around` squares of two triangles each.
template <class Radius>
scene::Scene film_between_rings(double half, int around, int along, Radius&& radius) {
  Builder b;
  std::vector<Vertex> v;
  for (int i = 0; i <= along; ++i) {
    const double z = half * (2.0 * i / along - 1);
    for (int j = 0; j < around; ++j) {
      const double a = 2 * M_PI * (j + 0.5 * (i % 2)) / around;
      v.push_back(b.vertex({radius(z) * std::cos(a), radius(z) * std::sin(a), z}));
    }
  }
  const auto at = [&](int i, int j) { return v[std::size_t(i * around + (j + around) % around)]; };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      if (i % 2 == 0) {
        b.triangle(at(i, j), at(i, j + 1), at(i + 1, j));
        b.triangle(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
      } else {
        b.triangle(at(i, j), at(i, j + 1), at(i + 1, j + 1));
        b.triangle(at(i, j), at(i + 1, j + 1), at(i + 1, j));
      }
    }
  }
  film::Column& fixed = b.film.columns(film::ElementKind::vertex)
                            .add(film::flag_column("fixed", film::Inheritance::New::parent));
  for (int j = 0; j < around; ++j) {
    fixed.set(at(0, j).index, 0, 1);
    fixed.set(at(along, j).index, 0, 1);
  }
  scene::Scene scene;
  scene.film = std::move(b.film);
  return scene;
}

// A catenoid r = c cosh(z/c) through rings of radius 1: c cosh(half/c) = 1 has two solutions for half below
// .6627; the one with the wide neck is a minimum, the other a saddle of one negative mode.
inline double neck_of_catenoid(double half, bool stable) {
  // c cosh(half/c) is lowest where half/c tanh(half/c) = 1, at half/c = 1.19968.
  double narrow = half / 30;
  double wide = half / 1.1996786402577339;
  if (stable) {
    narrow = wide;
    wide = 1;
  }
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (narrow + wide);
    const bool above = middle * std::cosh(half / middle) > 1;
    (above == stable ? wide : narrow) = middle;
  }
  return 0.5 * (narrow + wide);
}

inline scene::Scene catenoid(double half, bool stable, int around, int along) {
  const double c = neck_of_catenoid(half, stable);
  return film_between_rings(half, around, along, [c](double z) { return c * std::cosh(z / c); });
}

}  // namespace lamella::test
