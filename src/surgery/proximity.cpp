#include "surgery/proximity.h"

#include <algorithm>
#include <cmath>

#include "surgery/sizing.h"

namespace lamella::surgery {

using film::EdgeEnd;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// A pair counts where the way between them leaves both sheets at more than 30 degrees: what lies beside a
// vertex in its own sheet does not.
constexpr double least_facing = 0.5;

using Corners = std::array<Vec3, 3>;

Corners corners_at(const Film& film, std::span<const Vec3> positions, Triangle t) {
  const auto& c = film.corners(t);
  return {positions[c[0].index], positions[c[1].index], positions[c[2].index]};
}

bool faces(const Corners& triangle, const Vec3& way) {
  const Vec3 n = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  return std::abs(dot(n, way)) >= least_facing * length(n) * length(way);
}

// Whether facets touch a vertex or one of its neighbours, asked for one vertex after the other.
class Ring {
 public:
  explicit Ring(const Film& film) : film_(film), around_(film.vertex_rows()) {}
  void go_to(Vertex v) {
    if (at_ == v) return;
    at_ = v;
    around_[v.index] = v;
    film_.for_each_end(v, [&](EdgeEnd end) { around_[film_.head(end.outward()).index] = v; });
  }
  bool touches(Triangle t) const {
    const auto& c = film_.corners(t);
    return around_[c[0].index] == at_ || around_[c[1].index] == at_ || around_[c[2].index] == at_;
  }

 private:
  const Film& film_;
  Vertex at_;
  std::vector<Vertex> around_;  // the last vertex gone to that each is, or is next to
};

}  // namespace

// After C. Ericson's case analysis by the signs of barycentric coordinates.
Vec3 nearest_point(const Corners& t, const Vec3& p) {
  const Vec3 ab = t[1] - t[0];
  const Vec3 ac = t[2] - t[0];
  const Vec3 ap = p - t[0];
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const Vec3 bp = p - t[1];
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + (d1 / (d1 - d3)) * ab;
  const Vec3 cp = p - t[2];
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return t[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (t[2] - t[1]);
  const double sum = va + vb + vc;
  return t[0] + (vb / sum) * ab + (vc / sum) * ac;
}

void Proximity::update(const Film& film, film::FacetCells& cells) {
  const std::span<const Vec3> positions = film.positions();
  bool stale = connectivity_ != film.connectivity_revision() || built_at_.size() != positions.size();
  for (std::size_t v = 0; v < positions.size() && !stale; ++v) {
    const double most = 0.5 * margin_ * sizes_[v];
    stale = squared_length(positions[v] - built_at_[v]) > most * most;
  }
  if (!stale) return;
  if (!cells.holds(film)) cells.make(film);
  build(film, cells);
}

void Proximity::build(const Film& film, film::FacetCells& cells) {
  const std::span<const Vec3> positions = film.positions();
  ++builds_;
  connectivity_ = film.connectivity_revision();
  built_at_.assign(positions.begin(), positions.end());
  sizes_.resize(positions.size());
  for (std::uint32_t v = 0; v < sizes_.size(); ++v)
    sizes_[v] = film.alive(Vertex(v)) ? size_of(film, Vertex(v)) : 0;
  pairs_.clear();
  asked_.clear();
  askers_.clear();
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const Vertex v(i);
    if (!film.alive(v) || !film.first_end(v).valid()) continue;
    askers_.push_back(v);
    asked_.push_back(film::box_of(std::span(&positions[i], 1), (reach_ + margin_) * sizes_[i]));
  }
  Ring ring(film);
  cells.for_each_near(asked_, [&](std::uint32_t i, Triangle facet) {
    const Vertex v = askers_[i];
    const double reach = (reach_ + margin_) * sizes_[v.index];
    const Vec3& at = positions[v.index];
    ring.go_to(v);
    if (ring.touches(facet)) return;
    const Corners t = corners_at(film, positions, facet);
    const Vec3 way = at - nearest_point(t, at);
    if (squared_length(way) < reach * reach && faces(t, way)) pairs_.push_back({v, facet});
  });
}

std::vector<Contact> Proximity::contacts(const Film& film, std::span<const Vec3> positions) const {
  std::vector<Contact> found;
  for (const NearPair& pair : pairs_) {
    const Vec3& p = positions[pair.vertex.index];
    const Corners t = corners_at(film, positions, pair.facet);
    const Vec3 at = nearest_point(t, p);
    const double distance = length(p - at);
    if (distance < reach_ * sizes_[pair.vertex.index] && faces(t, p - at))
      found.push_back({pair, distance, at});
  }
  std::sort(found.begin(), found.end(),
            [](const Contact& a, const Contact& b) { return a.distance < b.distance; });
  return found;
}

}  // namespace lamella::surgery
