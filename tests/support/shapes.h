// Films built in code, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "film/film.h"
#include "scene/scene.h"

namespace lamella::test {

using film::Film;
using film::Region;
using film::RegionPair;
using film::SignedEdge;
using film::Vec3;
using film::Vertex;

// Adds triangles by their corners, making each edge once.
class Builder {
 public:
  Vertex vertex(const Vec3& p) { return film.add_vertex(p); }
  SignedEdge edge(Vertex a, Vertex b) {
    const auto key = std::minmax(a, b);
    const auto at = edges_.find(key);
    if (at != edges_.end()) return SignedEdge(at->second, film.ends(at->second)[0] != a);
    const film::Edge made = film.add_edge(a, b);
    edges_.emplace(key, made);
    return SignedEdge(made, false);
  }
  film::Triangle triangle(Vertex a, Vertex b, Vertex c, RegionPair regions = {}) {
    return film.add_triangle({edge(a, b), edge(b, c), edge(c, a)}, regions);
  }
  Film film;

 private:
  std::map<std::pair<Vertex, Vertex>, film::Edge> edges_;
};

inline scene::Body body_with_volume(double volume) {
  scene::Body body;
  body.target_volume = volume;
  return body;
}

// A cube's surface around region 1, each face cut in four at its centre.
inline scene::Scene cube(double side = 1, const Vec3& corner = {}) {
  Builder b;
  std::vector<Vertex> v;
  for (int i = 0; i < 8; ++i) {
    v.push_back(b.vertex(corner + side * Vec3{double(i & 1), double((i >> 1) & 1), double((i >> 2) & 1)}));
  }
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    Vec3 centre;
    for (const int i : f) centre += 0.25 * b.film.position(v[std::size_t(i)]);
    const Vertex c = b.vertex(centre);
    for (int k = 0; k < 4; ++k) {
      b.triangle(v[std::size_t(f[k])], v[std::size_t(f[(k + 1) % 4])], c, {Region{0}, Region{1}});
    }
  }
  b.film.sort_all_sides();
  scene::Scene scene;
  scene.film = std::move(b.film);
  scene.bodies.push_back(body_with_volume(side * side * side));
  return scene;
}

// A flat square film with the same region on both sides, n by n squares of two triangles, rim fixed.
inline scene::Scene square_film(int n, double side = 1) {
  Builder b;
  std::vector<Vertex> v;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) v.push_back(b.vertex({side * i / n, side * j / n, 0}));
  }
  const auto at = [&](int i, int j) { return v[std::size_t(i * (n + 1) + j)]; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      b.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      b.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  film::Column& fixed = b.film.columns(film::ElementKind::vertex)
                            .add(film::flag_column("fixed", film::Inheritance::New::parent));
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      if (i == 0 || j == 0 || i == n || j == n) fixed.set(at(i, j).index, 0, 1);
    }
  }
  scene::Scene scene;
  scene.film = std::move(b.film);
  return scene;
}

// A foam of cells on a cubic grid: each of n^3 cells belongs to a random region of 0..regions, and films
// stand where neighbours differ. Vertices are moved at random by up to `jitter` cell sides. Borders of three
// and four films, touching edges and isolated contacts all occur.
inline scene::Scene random_foam(unsigned seed, int n = 3, std::uint32_t regions = 4, double jitter = 0.15) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::uint32_t> label(0, regions);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  std::vector<std::uint32_t> cells(std::size_t(n * n * n));
  for (std::uint32_t& c : cells) c = label(random);
  const auto region = [&](int i, int j, int k) {
    const bool inside = i >= 0 && j >= 0 && k >= 0 && i < n && j < n && k < n;
    return Region{inside ? cells[std::size_t((i * n + j) * n + k)] : 0};
  };
  Builder b;
  std::map<std::array<int, 3>, Vertex> known;
  const auto vertex = [&](int i, int j, int k) {
    const auto [at, added] = known.try_emplace({i, j, k});
    if (added) at->second = b.vertex({i + shift(random), j + shift(random), k + shift(random)});
    return at->second;
  };
  const auto wall = [&](Region behind, Region front, std::array<Vertex, 4> c) {
    if (behind == front) return;
    b.triangle(c[0], c[1], c[2], {front, behind});
    b.triangle(c[0], c[2], c[3], {front, behind});
  };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      for (int k = 0; k <= n; ++k) {
        wall(region(i - 1, j, k), region(i, j, k),
             {vertex(i, j, k), vertex(i, j + 1, k), vertex(i, j + 1, k + 1), vertex(i, j, k + 1)});
        wall(region(i, j - 1, k), region(i, j, k),
             {vertex(i, j, k), vertex(i, j, k + 1), vertex(i + 1, j, k + 1), vertex(i + 1, j, k)});
        wall(region(i, j, k - 1), region(i, j, k),
             {vertex(i, j, k), vertex(i + 1, j, k), vertex(i + 1, j + 1, k), vertex(i, j + 1, k)});
      }
    }
  }
  for (std::uint32_t v = 0; v < b.film.vertex_rows(); ++v) {
    if (!b.film.first_end(Vertex(v)).valid()) b.film.remove(Vertex(v));
  }
  b.film.compact();
  b.film.restart_numbers();
  b.film.sort_all_sides();
  scene::Scene scene;
  scene.film = std::move(b.film);
  for (std::uint32_t r = 1; r <= regions; ++r) scene.bodies.push_back(body_with_volume(1));
  return scene;
}

// A hemisphere-like open cap over the unit circle at height `base`, as body 1: open below.
inline scene::Scene open_cap(double base = 0.5, int around = 8) {
  Builder b;
  std::vector<Vertex> ring;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * M_PI * i / around;
    ring.push_back(b.vertex({std::cos(a) + 0.3, std::sin(a) - 0.2, base + 0.1 * std::sin(3 * a)}));
  }
  const Vertex top = b.vertex({0.2, 0.1, base + 1});
  for (int i = 0; i < around; ++i) {
    b.triangle(ring[std::size_t(i)], ring[std::size_t((i + 1) % around)], top, {Region{0}, Region{1}});
  }
  scene::Scene scene;
  scene.film = std::move(b.film);
  scene.bodies.push_back(body_with_volume(1));
  return scene;
}

inline void move_all(Film& film, const Vec3& by) {
  for (Vec3& p : film.edit_positions()) p += by;
}

// Turns all positions about an axis through the origin (Rodrigues).
inline void rotate_all(Film& film, const Vec3& axis, double angle) {
  const Vec3 k = unit(axis);
  for (Vec3& p : film.edit_positions()) {
    p = std::cos(angle) * p + std::sin(angle) * cross(k, p) + (1 - std::cos(angle)) * dot(k, p) * k;
  }
}

inline void jitter(Film& film, unsigned seed, double by) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-by, by);
  for (Vec3& p : film.edit_positions()) p += Vec3{shift(random), shift(random), shift(random)};
}

}  // namespace lamella::test
