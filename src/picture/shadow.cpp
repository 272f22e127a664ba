#include "picture/shadow.h"

#include <algorithm>
#include <cmath>

namespace lamella::picture {

namespace {

using film::Vec3;

constexpr double film_shade = 0.16;  // of one film seen from above
constexpr double tube_shade = 0.7;
constexpr double gap = 0.04;  // between the scene and the ground, in its own size
constexpr double margin_around = 0.35;
constexpr double softness = 0.035;  // radius of the blur, in the size of the square
constexpr double darkest = 0.55;

Vec3 point(const Point& p) {
  return {p[0], p[1], p[2]};
}

// Means over 2r + 1 cells along rows, then along columns; three times for a bell.
void blur(std::vector<float>& grid, int size, int radius) {
  std::vector<float> row(static_cast<std::size_t>(size));
  const auto pass = [&](std::size_t first, std::size_t stride) {
    double sum = 0;
    const auto cell = [&](int i) -> float& { return grid[first + static_cast<std::size_t>(i) * stride]; };
    for (int i = 0; i < radius && i < size; ++i) sum += cell(i);
    for (int i = 0; i < size; ++i) {
      if (i + radius < size) sum += cell(i + radius);
      if (i - radius - 1 >= 0) sum -= cell(i - radius - 1);
      row[static_cast<std::size_t>(i)] = static_cast<float>(sum / (2 * radius + 1));
    }
    for (int i = 0; i < size; ++i) cell(i) = row[static_cast<std::size_t>(i)];
  };
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < size; ++i) pass(static_cast<std::size_t>(i) * static_cast<std::size_t>(size), 1);
    for (int i = 0; i < size; ++i) pass(static_cast<std::size_t>(i), static_cast<std::size_t>(size));
  }
}

}  // namespace

// Shade is thrown as by points strewn over films and along tubes, each of the cell's size.
GroundShadow::GroundShadow(const Drawing& drawing) {
  const std::vector<Point> outline = drawing.outline();
  if (outline.empty()) return;
  Vec3 low = point(outline[0]);
  Vec3 high = low;
  for (const Point& p : outline) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point(p)[axis]);
      high[axis] = std::max(high[axis], point(p)[axis]);
    }
  }
  const Vec3 size = high - low;
  const double width = (1 + 2 * margin_around) * std::max({size.x, size.y, 0.3 * size.z});
  if (!(width > 0)) return;
  cell_ = width / cells;
  ground_ = low.z - gap * std::max({size.x, size.y, size.z});
  left_ = (low.x + high.x - width) / 2;
  front_ = (low.y + high.y - width) / 2;
  shade_.assign(static_cast<std::size_t>(cells) * cells, 0.0F);
  const auto add = [&](const Vec3& p, double area) {
    const int i = std::clamp(static_cast<int>((p.x - left_) / cell_), 0, cells - 1);
    const int j = std::clamp(static_cast<int>((p.y - front_) / cell_), 0, cells - 1);
    shade_[static_cast<std::size_t>(j) * cells + static_cast<std::size_t>(i)] +=
        static_cast<float>(area / (cell_ * cell_));
  };
  for (const auto& t : drawing.triangles) {
    const Vec3 a = point(drawing.positions[t[0]]);
    const Vec3 u = point(drawing.positions[t[1]]) - a;
    const Vec3 v = point(drawing.positions[t[2]]) - a;
    const double area = std::abs(cross(u, v).z) / 2;
    const int parts = std::clamp(static_cast<int>(std::ceil(std::sqrt(area) / cell_)) + 1, 1, cells);
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; j < parts - i; ++j)
        add(a + ((i + 0.33) / parts) * u + ((j + 0.33) / parts) * v,
            film_shade * area * 2 / (parts * (parts + 1)));
    }
  }
  for (const Tube& tube : drawing.tubes) {
    const Vec3 from = point(tube.from);
    const Vec3 way = point(tube.to) - from;
    const int parts = std::clamp(static_cast<int>(length(way) / cell_) + 1, 1, 2 * cells);
    for (int i = 0; i < parts; ++i)
      add(from + ((i + 0.5) / parts) * way, tube_shade * 2 * tube.radius * std::hypot(way.x, way.y) / parts);
  }
  blur(shade_, cells, std::max(1, static_cast<int>(softness * cells)));
}

// Between the middles of cells the shade changes evenly.
double GroundShadow::at(double x, double y) const {
  const double column = (x - left_) / cell_ - 0.5;
  const double row = (y - front_) / cell_ - 0.5;
  if (!(column >= 0 && row >= 0 && column < cells - 1 && row < cells - 1)) return 0;
  const auto i = static_cast<std::size_t>(column);
  const auto j = static_cast<std::size_t>(row);
  const double s = column - static_cast<double>(i);
  const double t = row - static_cast<double>(j);
  const auto shade = [&](std::size_t k, std::size_t l) { return static_cast<double>(shade_[l * cells + k]); };
  return (1 - t) * ((1 - s) * shade(i, j) + s * shade(i + 1, j)) +
         t * ((1 - s) * shade(i, j + 1) + s * shade(i + 1, j + 1));
}

float GroundShadow::light(const Camera& camera, double x, double y) const {
  if (cell_ == 0) return 1;
  const double across = (x - camera.x_shift) / camera.x_scale;
  const double up = (y - camera.y_shift) / camera.y_scale;
  const auto from_view = [&](const Vec3& v) {
    return v.x * camera.axes[0] + v.y * camera.axes[1] + v.z * camera.axes[2];
  };
  const Vec3 start =
      from_view(camera.parallel ? Vec3{across + camera.eye.x, up + camera.eye.y, camera.eye.z} : camera.eye);
  const Vec3 way = from_view(camera.parallel ? Vec3{0, 0, -1} : Vec3{across, up, -1});
  if (!(way.z < 0) || (!camera.parallel && start.z <= ground_)) return 1;
  const Vec3 hit = start + ((ground_ - start.z) / way.z) * way;
  return static_cast<float>(1 - std::min(darkest, at(hit.x, hit.y)));
}

}  // namespace lamella::picture
