#include "picture/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamella::picture::scenes {

using film::Edge;
using film::RegionPair;
using film::SignedEdge;
using film::Vec3;
using film::Vertex;

Vertex Builder::vertex(const Vec3& p) {
  const std::array<long, 3> key = {std::lround(p.x * 1e7), std::lround(p.y * 1e7), std::lround(p.z * 1e7)};
  const auto [at, is_new] = vertex_at_.try_emplace(key);
  if (is_new) at->second = scene_.film.add_vertex(p);
  return at->second;
}

Edge Builder::edge(Vertex a, Vertex b) {
  const auto [at, is_new] = edge_between_.try_emplace(std::minmax(a, b));
  if (is_new) at->second = scene_.film.add_edge(a, b);
  return at->second;
}

SignedEdge Builder::signed_edge(Vertex a, Vertex b) {
  const Edge e = edge(a, b);
  return {e, scene_.film.ends(e)[0] != a};
}

void Builder::triangle(Vertex a, Vertex b, Vertex c, RegionPair regions) {
  if (a == b || b == c || c == a) return;
  scene_.film.add_triangle({signed_edge(a, b), signed_edge(b, c), signed_edge(c, a)}, regions);
}

void Builder::patch(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int n, RegionPair regions) {
  const auto at = [&](int i, int j) {
    const double u = static_cast<double>(i) / n;
    const double v = static_cast<double>(j) / n;
    return vertex((1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), regions);
      triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), regions);
    }
  }
}

void Builder::fix(Edge e) {
  fixed_.push_back(e);
}

scene::Scene Builder::finish() {
  if (!fixed_.empty()) {
    film::Columns& columns = scene_.film.columns(film::ElementKind::edge);
    columns.add(film::flag_column("fixed"));
    for (const Edge e : fixed_) columns.edit("fixed")->set(e.index, 0, 1);
  }
  scene_.film.sort_all_sides();
  return std::move(scene_);
}

namespace {

void square(Builder& b, double x, double y, double z, int n) {
  b.patch({x - 1, y - 1, z}, {x + 1, y - 1, z}, {x + 1, y + 1, z}, {x - 1, y + 1, z}, n);
}

// The part of a sphere around `centre` on the x axis from its pole in direction `towards` (1 or -1) to the
// plane x = rim_x, wound to have the centre behind it. For radius 0 a flat disc of radius `rim` in that
// plane.
void cap(Builder& b, double centre, double radius, double towards, double rim, double rim_x, int n,
         RegionPair regions) {
  const int around = 4 * n;
  const double last = radius > 0 ? std::acos((rim_x - centre) / radius * towards) : 0;
  const auto at = [&](int ring, int step) {
    const double phi = 2 * M_PI * step / around;
    const double part = static_cast<double>(ring) / n;
    const double x = radius > 0 ? centre + towards * radius * std::cos(part * last) : rim_x;
    const double r = radius > 0 ? radius * std::sin(part * last) : rim * part;
    return b.vertex({x, r * std::cos(phi), r * std::sin(phi)});
  };
  const auto add = [&](Vertex u, Vertex v, Vertex w) {
    towards > 0 ? b.triangle(u, v, w, regions) : b.triangle(u, w, v, regions);
  };
  for (int ring = 0; ring < n; ++ring) {
    for (int step = 0; step < around; ++step) {
      add(at(ring, step), at(ring + 1, step), at(ring + 1, step + 1));
      add(at(ring, step), at(ring + 1, step + 1), at(ring, step + 1));
    }
  }
}

}  // namespace

scene::Scene square_film(int n, double height) {
  Builder b;
  square(b, 0, 0, height, n);
  return b.finish();
}

scene::Scene two_square_films(int n) {
  Builder b;
  square(b, 0, 0, 0, n);
  square(b, 1, 1, 0.5, n);
  return b.finish();
}

scene::Scene sphere(int n) {
  Builder b;
  cap(b, 0, 1, 1, 1, 0, n, {film::Region{0}, film::Region{1}});
  cap(b, 0, 1, -1, 1, 0, n, {film::Region{0}, film::Region{1}});
  return b.finish();
}

scene::Scene double_bubble(int n, double second) {
  // The centres and the common circle from the triangle of sides 1, `second` with 60 degrees between them.
  const double distance = std::sqrt(1 + second * second - second);
  const double rim_x = (distance * distance + 1 - second * second) / (2 * distance);
  const double rim = std::sqrt(1 - rim_x * rim_x);
  const double between = second < 1 ? 1 / (1 / second - 1) : 0;
  Builder b;
  cap(b, 0, 1, -1, rim, rim_x, n, {film::Region{0}, film::Region{1}});
  cap(b, distance, second, 1, rim, rim_x, n, {film::Region{0}, film::Region{2}});
  // The smaller bubble, of higher pressure, bulges into the larger one.
  const double centre = rim_x + std::sqrt(std::max(0.0, between * between - rim * rim));
  cap(b, centre, between, -1, rim, rim_x, n, {film::Region{1}, film::Region{2}});
  return b.finish();
}

scene::Scene wire_cube(int n) {
  Builder b;
  const double s = 0.14;
  const auto corner = [](int x, int y, int z) { return Vec3{x - 0.0, y - 0.0, z - 0.0}; };
  const auto inner = [&](int x, int y) { return Vec3{s * x, s * y, 0}; };
  b.patch(inner(-1, -1), inner(1, -1), inner(1, 1), inner(-1, 1), n);
  constexpr int turn[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (int k = 0; k < 4; ++k) {
    const auto [x, y] = std::pair(turn[k][0], turn[k][1]);
    const auto [u, v] = std::pair(turn[k + 1][0], turn[k + 1][1]);
    for (const int z : {-1, 1}) b.patch(corner(x, y, z), corner(u, v, z), inner(u, v), inner(x, y), n);
    // A triangle, as a patch of which one side has no length.
    b.patch(corner(x, y, -1), corner(x, y, 1), inner(x, y), inner(x, y), n);
  }
  const auto fix_line = [&](const Vec3& from, const Vec3& to) {
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int j) { return b.vertex(from + (static_cast<double>(j) / n) * (to - from)); };
      b.fix(b.edge(at(i), at(i + 1)));
    }
  };
  for (int k = 0; k < 4; ++k) {
    for (const int z : {-1, 1})
      fix_line(corner(turn[k][0], turn[k][1], z), corner(turn[k + 1][0], turn[k + 1][1], z));
    fix_line(corner(turn[k][0], turn[k][1], -1), corner(turn[k][0], turn[k][1], 1));
  }
  return b.finish();
}

scene::Scene catenoid(int n) {
  Builder b;
  const int around = 6 * n;
  const auto at = [&](int ring, int step) {
    const double z = 0.55 * (2.0 * ring / n - 1);
    const double phi = 2 * M_PI * step / around;
    return b.vertex({std::cosh(z) * std::cos(phi), std::cosh(z) * std::sin(phi), z});
  };
  for (int ring = 0; ring < n; ++ring) {
    for (int step = 0; step < around; ++step) {
      b.triangle(at(ring, step), at(ring, step + 1), at(ring + 1, step + 1));
      b.triangle(at(ring, step), at(ring + 1, step + 1), at(ring + 1, step));
    }
  }
  for (int step = 0; step < around; ++step) {
    for (const int ring : {0, n}) b.fix(b.edge(at(ring, step), at(ring, step + 1)));
  }
  return b.finish();
}

scene::Scene lattice(int n, int m) {
  Builder b;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const double x = i;
        const double y = j;
        const double z = k;
        b.patch({x, y, z}, {x, y + 1, z}, {x, y + 1, z + 1}, {x, y, z + 1}, m);
        b.patch({z, x, y}, {z + 1, x, y}, {z + 1, x, y + 1}, {z, x, y + 1}, m);
        b.patch({y, z, x}, {y + 1, z, x}, {y + 1, z + 1, x}, {y, z + 1, x}, m);
      }
    }
  }
  return b.finish();
}

namespace {

// One half of the faces of each cell suffices where its neighbours bring the others; the hull takes all.
void kelvin_cell(Builder& b, std::map<std::array<long, 3>, bool>& done, const Vec3& centre, int m) {
  const auto face = [&](const std::vector<Vec3>& corners) {
    Vec3 middle;
    for (const Vec3& c : corners) middle += c / static_cast<double>(corners.size());
    const Vec3 key = centre + middle;
    if (std::exchange(done[{std::lround(key.x * 100), std::lround(key.y * 100), std::lround(key.z * 100)}],
                      true))
      return;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3& c = corners[i];
      const Vec3 before = (c + corners[(i + count - 1) % count]) / 2;
      const Vec3 after = (c + corners[(i + 1) % count]) / 2;
      b.patch(centre + middle, centre + before, centre + c, centre + after, m);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double s : {-1.0, 1.0}) {
      const auto v = [&](double p, double q) {
        Vec3 r;
        r[axis] = s;
        r[(axis + 1) % 3] = p / 2;
        r[(axis + 2) % 3] = q / 2;
        return r;
      };
      face({v(1, 0), v(0, 1), v(-1, 0), v(0, -1)});
    }
  }
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        face({{x, y / 2, 0}, {x / 2, y, 0}, {0, y, z / 2}, {0, y / 2, z}, {x / 2, 0, z}, {x, 0, z / 2}});
      }
    }
  }
}

}  // namespace

scene::Scene kelvin(int n, int m) {
  Builder b;
  std::map<std::array<long, 3>, bool> done;
  for (int i = 0; i < 2 * n - 1; ++i) {
    for (int j = 0; j < 2 * n - 1; ++j) {
      for (int k = 0; k < 2 * n - 1; ++k) {
        if (i % 2 != j % 2 || j % 2 != k % 2) continue;
        kelvin_cell(b, done, {i + 0.0, j + 0.0, k + 0.0}, m);
      }
    }
  }
  return b.finish();
}

scene::Scene twisted_band(int n, int turns) {
  Builder b;
  const int around = 12 * n;
  const auto at = [&](int step, int across) {
    const bool past = step == around;  // back at the start, upside down after an odd number of half turns
    const double phi = past ? 0 : 2 * M_PI * step / around;
    const double side = 0.4 * (2.0 * across / n - 1) * (past && turns % 2 != 0 ? -1 : 1);
    const double tilt = turns * phi / 2;
    const double r = 1 + side * std::cos(tilt);
    return b.vertex({r * std::cos(phi), r * std::sin(phi), side * std::sin(tilt)});
  };
  for (int step = 0; step < around; ++step) {
    for (int across = 0; across < n; ++across) {
      b.triangle(at(step, across), at(step + 1, across), at(step + 1, across + 1));
      b.triangle(at(step, across), at(step + 1, across + 1), at(step, across + 1));
    }
    for (const int across : {0, n}) b.fix(b.edge(at(step, across), at(step + 1, across)));
  }
  return b.finish();
}

}  // namespace lamella::picture::scenes
