#include "exchange/tubes.h"

#include <cmath>
#include <map>
#include <numbers>

namespace lamella::exchange {

using film::Vec3;

namespace {

constexpr std::uint32_t sides = 10;

// Any direction across another.
Vec3 across(const Vec3& direction) {
  const Vec3 axis = std::abs(direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return unit(cross(direction, axis));
}

// Directions along a line at its points.
std::vector<Vec3> tangents(const std::vector<Vec3>& points, bool loop) {
  const std::size_t last = points.size() - 1;
  std::vector<Vec3> result;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vec3& before = i > 0 ? points[i - 1] : loop ? points[last - 1] : points[0];
    const Vec3& after = i < last ? points[i + 1] : loop ? points[1] : points[last];
    const Vec3 along = unit(after - before);
    result.push_back(length(along) > 0 ? along : result.empty() ? Vec3{0, 0, 1} : result.back());
  }
  return result;
}

void add_ring(Solid& solid, const Vec3& middle, const Vec3& first, const Vec3& second, double radius) {
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
    solid.points.push_back(middle + radius * out);
    solid.normals.push_back(out);
  }
}

// Between rings that begin at these points, seen from outside.
void add_band(Solid& solid, std::uint32_t lower, std::uint32_t upper) {
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t next = (k + 1) % sides;
    solid.triangles.push_back({lower + k, lower + next, upper + next});
    solid.triangles.push_back({lower + k, upper + next, upper + k});
  }
}

}  // namespace

void add_tube(Solid& solid, const Mesh& mesh, const Line& line, double radius) {
  std::vector<Vec3> points;
  for (const std::uint32_t p : line.points) points.push_back(mesh.points[p]);
  const bool loop = line.points.front() == line.points.back() && points.size() > 2;
  const std::vector<Vec3> along = tangents(points, loop);
  Vec3 first = across(along.front());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 carried = first - dot(first, along[i]) * along[i];
    first = length(carried) > 1e-6 ? unit(carried) : across(along[i]);
    const auto ring = static_cast<std::uint32_t>(solid.points.size());
    add_ring(solid, points[i], first, cross(along[i], first), radius);
    if (i > 0) add_band(solid, ring - sides, ring);
  }
}

void add_ball(Solid& solid, const Vec3& middle, double radius) {
  constexpr std::uint32_t bands = 6;
  for (std::uint32_t j = 0; j <= bands; ++j) {
    const double polar = std::numbers::pi * (1 - static_cast<double>(j) / bands);
    const auto ring = static_cast<std::uint32_t>(solid.points.size());
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      const Vec3 out{std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)};
      solid.points.push_back(middle + radius * out);
      solid.normals.push_back(out);
    }
    if (j > 0) add_band(solid, ring - sides, ring);
  }
}

Solid tubes_of(const Mesh& mesh, picture::LineKind kind, double radius) {
  constexpr double quad_point = 1.7;
  constexpr int borders_at_quad_point = 4;
  Solid solid;
  std::map<std::uint32_t, int> ends;
  for (const Line& line : mesh.lines) {
    if (line.kind != kind || line.points.size() < 2) continue;
    add_tube(solid, mesh, line, radius);
    for (const std::uint32_t p : {line.points.front(), line.points.back()}) ++ends[p];
  }
  for (const auto& [point, count] : ends) {
    if (kind == picture::LineKind::border && count >= borders_at_quad_point) {
      add_ball(solid, mesh.points[point], quad_point * radius);
    } else {
      add_ball(solid, mesh.points[point], radius);
    }
  }
  return solid;
}

}  // namespace lamella::exchange
