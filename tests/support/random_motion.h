// Scenes made at random, and what befalls them: bubbles in clusters and apart, with and without a film in a
// frame; kicks, pulls, bursts. The same seed makes the same scene on any machine.
#pragma once

#include <cstdint>

#include "energy/measure.h"
#include "evolution/masses.h"
#include "support/shapes.h"
#include "surgery/burst.h"
#include "surgery/pop.h"
#include "surgery/refine.h"
#include "surgery/regions.h"

namespace lamella::test {

// Numbers without the standard library's distributions, which differ from one implementation to the next.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : engine_(seed) {}
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  int below(int n) { return static_cast<int>(real(0, n)); }
  Vec3 vector(double most) { return {real(-most, most), real(-most, most), real(-most, most)}; }

 private:
  std::mt19937 engine_;
};

// Cubic bubbles of side 1 where a grid of n^3 cells has a number above 0, which is that of the region.
class Cells {
 public:
  Cells(int n, double jitter, Chance& chance)
      : n_(n), jitter_(jitter), chance_(chance), region_(std::size_t(n * n * n)) {}

  std::uint32_t& at(int i, int j, int k) { return region_[std::size_t((i * n_ + j) * n_ + k)]; }

  void build(Builder& b) {
    for (int i = 0; i <= n_; ++i) {
      for (int j = 0; j <= n_; ++j) {
        for (int k = 0; k <= n_; ++k) {
          wall(b, here(i - 1, j, k), here(i, j, k),
               {{{i, j, k}, {i, j + 1, k}, {i, j + 1, k + 1}, {i, j, k + 1}}});
          wall(b, here(i, j - 1, k), here(i, j, k),
               {{{i, j, k}, {i, j, k + 1}, {i + 1, j, k + 1}, {i + 1, j, k}}});
          wall(b, here(i, j, k - 1), here(i, j, k),
               {{{i, j, k}, {i + 1, j, k}, {i + 1, j + 1, k}, {i, j + 1, k}}});
        }
      }
    }
  }

 private:
  using Place = std::array<int, 3>;
  Region here(int i, int j, int k) {
    const bool inside = i >= 0 && j >= 0 && k >= 0 && i < n_ && j < n_ && k < n_;
    return Region{inside ? at(i, j, k) : 0};
  }
  Vertex vertex(Builder& b, const Place& p) {
    const auto [found, added] = known_.try_emplace(p);
    if (added)
      found->second = b.vertex(Vec3{double(p[0]), double(p[1]), double(p[2])} + chance_.vector(jitter_));
    return found->second;
  }
  void wall(Builder& b, Region behind, Region front, const std::array<Place, 4>& c) {
    if (behind == front) return;
    std::array<Vertex, 4> v;
    for (std::size_t m = 0; m < 4; ++m) v[m] = vertex(b, c[m]);
    b.triangle(v[0], v[1], v[2], {front, behind});
    b.triangle(v[0], v[2], v[3], {front, behind});
  }

  int n_;
  double jitter_;
  Chance& chance_;
  std::vector<std::uint32_t> region_;
  std::map<Place, Vertex> known_;
};

// A flat film in a fixed square frame below the cells.
inline void add_framed_film(Builder& b, double low, double high, double z) {
  constexpr int n = 5;
  std::vector<Vertex> v;
  film::Column& fixed = b.film.columns(film::ElementKind::vertex)
                            .add(film::flag_column("fixed", film::Inheritance::New::parent));
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j)
      v.push_back(b.vertex({low + (high - low) * i / n, low + (high - low) * j / n, z}));
  }
  const auto at = [&](int i, int j) { return v[std::size_t(i * (n + 1) + j)]; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      b.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      b.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  for (int i = 0; i <= n; ++i) {
    for (const Vertex w : {at(i, 0), at(i, n), at(0, i), at(n, i)}) fixed.set(w.index, 0, 1);
  }
}

// Up to `most` bubbles. Every fourth scene has a framed film as well; half of them are clusters, half apart.
inline scene::Scene random_bubbles(std::uint32_t seed, int most) {
  Chance chance(seed);
  const int n = most > 60 ? 6 : most > 8 ? 4 : 3;
  const bool apart = seed % 2 == 0;
  const int wanted = 2 + chance.below(most - 1);
  Builder b;
  Cells grid(n, 0.12, chance);
  std::uint32_t count = 0;
  // A walk: to any neighbour in a cluster, two cells on if apart.
  std::array<int, 3> place{n / 2, n / 2, n / 2};
  for (int tries = 0; tries < 40 * wanted && int(count) < wanted; ++tries) {
    std::uint32_t& cell = grid.at(place[0], place[1], place[2]);
    if (cell == 0) cell = ++count;
    int& axis = place[std::size_t(chance.below(3))];
    axis += (chance.below(2) == 0 ? 1 : -1) * (apart ? 2 : 1);
    axis = std::clamp(axis, 0, n - 1);
  }
  grid.build(b);
  if (seed % 4 == 1) add_framed_film(b, -1, n + 1.0, -0.4);
  b.film.sort_all_sides();
  scene::Scene scene;
  scene.film = std::move(b.film);
  scene.bodies.resize(count);
  scene.body_columns.resize(count);
  const energy::Measures measures = energy::measure(scene);
  for (std::uint32_t r = 1; r <= count; ++r) scene.bodies[r - 1].target_volume = measures.volumes[r];
  surgery::refine(scene.film);
  if (seed % 3 != 0 && count < 12) surgery::refine(scene.film);
  scene.damping = chance.real(0, 1);
  return scene;
}

inline int bodies_present(const scene::Scene& scene) {
  int present = 0;
  for (const scene::Body& body : scene.bodies) present += body.absent ? 0 : 1;
  return present;
}

// What happens to a scene between two spells of motion. Returns its name. Nothing bursts where there are no
// more bodies than are to be `kept`, so that a long tale has bubbles to its end.
inline const char* befall(scene::Scene& scene, Chance& chance, int kept) {
  std::vector<Vec3> velocity = evolution::velocities(scene.film);
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  Vec3 middle;
  for (const Vec3& p : scene.film.positions()) middle += p / std::max(1.0, double(velocity.size()));
  // What has flown off is not hit harder than the rest.
  const auto from = [&](const Vec3& p) {
    const Vec3 way = p - middle;
    return way / std::max(1.0, length(way) / 2);
  };
  const auto add = [&](auto&& field) {
    for (std::size_t v = 0; v < velocity.size(); ++v) {
      if (fixed.empty() || fixed[v] == 0) velocity[v] += field(from(scene.film.positions()[v]));
    }
    evolution::store_velocities(scene.film, velocity);
  };
  const auto burst = [&](const std::optional<surgery::Event>& event) {
    if (!event) return;
    std::vector<surgery::Event> events{*event};
    surgery::settle_regions(scene, events, {});
    scene.film.compact();
  };
  switch (chance.below(6)) {
    case 0: {
      const double most = chance.real(0.1, 0.5);
      add([&](const Vec3&) { return chance.vector(most); });
      return "shaken";
    }
    case 1: {
      const Vec3 along = chance.vector(1);
      const double rate = chance.real(-0.8, 0.8);
      add([&](const Vec3& p) { return rate * dot(p, along) * along; });
      return "pulled";
    }
    case 2: {
      const Vec3 along = chance.vector(1.2);
      const Vec3 across = chance.vector(1);
      add([&](const Vec3& p) { return dot(p, across) * along; });
      return "sheared";
    }
    case 3: {
      if (bodies_present(scene) <= kept) return "none";
      const Region r{1 + std::uint32_t(chance.below(int(scene.bodies.size())))};
      if (!scene.body(r).absent) burst(surgery::burst_body(scene, r));
      return "burst of a bubble";
    }
    case 4: {
      if (bodies_present(scene) <= kept) return "none";
      burst(surgery::burst_sheet(
          scene, film::Triangle(std::uint32_t(chance.below(int(scene.film.triangle_rows()))))));
      return "burst of a film";
    }
    default:
      return "none";
  }
}

}  // namespace lamella::test
