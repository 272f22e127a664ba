#include "energy/plateau.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lamella::energy {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::Side;
using film::Vec3;
using film::Vertex;

namespace {

constexpr double degrees = 180 / M_PI;

class Deviations {
 public:
  explicit Deviations(double ideal) : ideal_(ideal) {}
  void add(double angle) {
    const double off = (angle - ideal_) * degrees;
    squares_ += off * off;
    result_.worst = std::max(result_.worst, std::abs(off));
    ++result_.angles;
  }
  AngleDeviation result() const {
    AngleDeviation r = result_;
    r.rms = r.angles > 0 ? std::sqrt(squares_ / static_cast<double>(r.angles)) : 0;
    return r;
  }

 private:
  double ideal_;
  double squares_ = 0;
  AngleDeviation result_;
};

bool held(const Film& film, Edge e) {
  const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
  return !fixed.empty() && fixed[film.ends(e)[0].index] != 0 && fixed[film.ends(e)[1].index] != 0;
}

bool is_wire(const Film& film, Edge e) {
  const auto fixed = film.columns(ElementKind::edge).flags("fixed");
  return !fixed.empty() && fixed[e.index] != 0;
}

// The direction from the edge into the film of a side, square to the edge.
Vec3 conormal(const Film& film, Side s, const Vec3& axis) {
  const Vec3 d = film::apex_direction(film, s);
  return d - dot(d, axis) * axis;
}

void add_border(const Film& film, Edge e, Deviations& deviations) {
  const Vec3 axis = unit(film.vector(e));
  std::vector<Vec3> into;
  film.for_each_side(e, [&](Side s) { into.push_back(conormal(film, s, axis)); });
  for (std::size_t i = 0; i < into.size(); ++i) {
    const Vec3& a = into[i];
    const Vec3& b = into[(i + 1) % into.size()];
    double angle = std::atan2(dot(cross(a, b), axis), dot(a, b));
    if (angle < 0) angle += 2 * M_PI;
    deviations.add(angle);
  }
}

}  // namespace

PlateauAngles plateau_angles(const Film& film) {
  PlateauAngles result;
  Deviations triple(2 * M_PI / 3);
  Deviations quad(std::acos(-1.0 / 3));
  std::vector<std::uint8_t> borders_at(film.vertex_rows(), 0);
  std::vector<std::uint8_t> odd_at(film.vertex_rows(), 0);
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const Edge e(i);
    if (!film.alive(e)) continue;
    const int films = film.valence(e);
    if (films < 3) continue;
    // Not of a wire, even where the mesh is so coarse that nothing of the border can move yet.
    if (films > 3 && !is_wire(film, e)) ++result.other_borders;
    if (held(film, e)) continue;
    if (films == 3) add_border(film, e, triple);
    for (const Vertex v : film.ends(e)) {
      if (borders_at[v.index] < 255) ++borders_at[v.index];
      if (films > 3) odd_at[v.index] = 1;
    }
  }
  const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
  for (std::uint32_t i = 0; i < film.vertex_rows(); ++i) {
    if (borders_at[i] < 3 || (!fixed.empty() && fixed[i] != 0)) continue;
    if (borders_at[i] != 4 || odd_at[i] != 0) {
      ++result.other_points;
      continue;
    }
    std::vector<Vec3> along;
    film.for_each_end(Vertex(i), [&](EdgeEnd end) {
      if (film.valence(end.edge()) < 3) return;
      along.push_back(film.vector(end.outward()));
    });
    for (std::size_t a = 0; a < along.size(); ++a) {
      for (std::size_t b = a + 1; b < along.size(); ++b) quad.add(film::angle_between(along[a], along[b]));
    }
  }
  result.triple = triple.result();
  result.quad = quad.result();
  return result;
}

}  // namespace lamella::energy
