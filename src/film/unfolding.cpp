#include "film/unfolding.h"

#include <algorithm>
#include <map>

namespace lamella::film {

// A face is a triangle seen from one of its two sides; a region's boundary is the faces that look at it.
class Unfolding::Builder {
 public:
  Builder(const Film& film, Unfolding& result) : film_(film), result_(result) {}

  const std::vector<Wrap>& offsets() const { return offset_; }
  void run() {
    result_.vertices_ = film_.vertex_rows();
    place_triangles();
    place_edges();
    place_faces();
  }

 private:
  using Face = std::uint32_t;  // 2t behind triangle t, 2t + 1 in front of it

  Vertex row_of(Vertex v, const Wrap& wrap);
  void place_triangles();
  void place_edges();
  void place_faces();
  void place_neighbours(Face face, std::vector<Face>& waiting);
  void add_seam(Side from, Face face, const Wrap& gap);
  Region region_of(Face face) const {
    const RegionPair pair = film_.regions(Triangle(face / 2));
    return face % 2 == 0 ? pair.behind : pair.front;
  }
  // The faces on either side of the gap that follows a side, counterclockwise about its edge.
  Face face_after(Side s) const { return 2 * s.triangle().index + (film_.edge_of(s).reversed() ? 0 : 1); }
  Face face_before(Side s) const { return 2 * s.triangle().index + (film_.edge_of(s).reversed() ? 1 : 0); }
  // Of an edge's tail, as seen from the first corner of a side's triangle.
  Wrap tail_wrap(Side s) const {
    const std::array<Wrap, 3> corner = film_.corner_wraps(s.triangle());
    const int at = film_.edge_of(s).reversed() ? next_corner(s.corner()) : s.corner();
    return corner[static_cast<std::size_t>(at)];
  }

  const Film& film_;
  Unfolding& result_;
  std::map<std::pair<Vertex, Wrap>, Vertex> known_;
  std::vector<std::uint8_t> placed_;  // by face
  std::vector<Wrap> offset_;
};

Vertex Unfolding::Builder::row_of(Vertex v, const Wrap& wrap) {
  if (wrap == Wrap{}) return v;
  const auto [at, added] = known_.try_emplace({v, wrap}, Vertex(result_.rows()));
  if (added) result_.images_.push_back({v, film_.lattice()->shift(wrap)});
  return at->second;
}

void Unfolding::Builder::place_triangles() {
  for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) {
    const std::array<Wrap, 3> wrap = film_.corner_wraps(Triangle(t));
    const auto& corner = film_.corners(Triangle(t));
    result_.triangles_.push_back({corner[0], row_of(corner[1], wrap[1]), row_of(corner[2], wrap[2])});
  }
}

void Unfolding::Builder::place_edges() {
  for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
    const auto& [tail, head] = film_.ends(Edge(e));
    result_.edges_.push_back({tail, row_of(head, film_.wrap(SignedEdge(Edge(e), false)))});
  }
}

// Goes over each region's boundary from face to face and moves each to where its neighbour is.
void Unfolding::Builder::place_faces() {
  const Face faces = 2 * film_.triangle_rows();
  placed_.assign(faces, 0);
  offset_.resize(faces);
  std::vector<Face> waiting;
  for (Face start = 0; start < faces; ++start) {
    if (placed_[start] != 0 || region_of(start).outside()) continue;
    placed_[start] = 1;
    waiting.push_back(start);
    while (!waiting.empty()) {
      const Face face = waiting.back();
      waiting.pop_back();
      place_neighbours(face, waiting);
    }
  }
  for (Face face = 0; face < faces; ++face) {
    if (offset_[face] == Wrap{}) continue;
    result_.apart_.push_back(
        {face / 2, region_of(face), film_.lattice()->shift(offset_[face]), face % 2 == 0 ? 1.0 : -1.0});
  }
}

void Unfolding::Builder::place_neighbours(Face face, std::vector<Face>& waiting) {
  for (int k = 0; k < 3; ++k) {
    const Side side(Triangle(face / 2), k);
    // The face across the gap at this side on which the face looks.
    Side other = film_.next_around(side);
    Face there = face_before(other);
    if (face_after(side) != face) {
      while (film_.next_around(other) != side) other = film_.next_around(other);
      there = face_after(other);
    }
    if (region_of(there) != region_of(face)) continue;
    const Wrap wanted = tail_wrap(side) + offset_[face] - tail_wrap(other);
    if (placed_[there] == 0) {
      placed_[there] = 1;
      offset_[there] = wanted;
      waiting.push_back(there);
    } else if (offset_[there] != wanted && face < there) {
      add_seam(side, face, offset_[there] - wanted);
    }
  }
}

// The boundary is walked with the region behind it.
void Unfolding::Builder::add_seam(Side from, Face face, const Wrap& gap) {
  const auto k = static_cast<std::size_t>(from.corner());
  const auto& row = result_.triangles_[from.triangle().index];
  const bool turned = face % 2 == 1;
  const Vertex a = row[turned ? (k + 1) % 3 : k];
  const Vertex b = row[turned ? k : (k + 1) % 3];
  result_.seams_.push_back(
      {a, b, film_.lattice()->shift(gap), film_.lattice()->shift(offset_[face]), region_of(face)});
}

Unfolding::Unfolding(const Film& film) {
  Builder(film, *this).run();
}

std::vector<Wrap> Unfolding::face_offsets(const Film& film) {
  Unfolding unfolding;
  Builder builder(film, unfolding);
  builder.run();
  return builder.offsets();
}

std::span<const Vec3> Unfolding::extend(std::span<const Vec3> positions, std::vector<Vec3>& into) const {
  into.resize(rows());
  std::copy(positions.begin(), positions.end(), into.begin());
  for (std::size_t i = 0; i < images_.size(); ++i)
    into[vertices_ + i] = positions[images_[i].of.index] + images_[i].shift;
  return into;
}

std::array<Vec3, 3> points_at(const Film& film, Triangle t, std::span<const Vec3> positions) {
  std::array<Vec3, 3> points;
  for (std::size_t k = 0; k < 3; ++k) points[k] = positions[film.corners(t)[k].index];
  if (!film.periodic()) return points;
  const std::array<Wrap, 3> wrap = film.corner_wraps(t);
  for (std::size_t k = 1; k < 3; ++k) points[k] += film.lattice()->shift(wrap[k]);
  return points;
}

// A sum of det(a,b,c)/6 over triangles that are moved by m grows by m.A/3, A the vector area. Along a seam
// with gap m it varies by m.(dx x v)/3 more than the film's flux when points move by v. That is taken back by
// m.(p x q)/6 for each of its edges, whose own variation leaves (m.(p x v)/6) at its ends: the gaps around a
// vertex sum to zero, so only the periods by which p is away from its vertex are left of that, and they are
// subtracted.
void Unfolding::add_volumes(std::span<const Vec3> x, const Vec3& origin, std::span<double> volumes) const {
  for (const Apart& apart : apart_) {
    const auto& v = triangles_[apart.triangle];
    const Vec3& a = x[v[0].index];
    const Vec3 doubled = cross(x[v[1].index] - a, x[v[2].index] - a);
    volumes[apart.region.index] += apart.sign * dot(apart.offset, doubled) / 6;
  }
  const auto own = [&](Vertex row) { return x[vertex_of(row).index] - origin; };
  for (const Seam& seam : seams_) {
    const Vec3 from = x[seam.from.index] + seam.offset - origin;
    const Vec3 to = x[seam.to.index] + seam.offset - origin;
    const Vec3 sum = cross(from, to) - cross(to - own(seam.to), own(seam.to)) +
                     cross(from - own(seam.from), own(seam.from));
    volumes[seam.region.index] += dot(seam.gap, sum) / 6;
  }
}

}  // namespace lamella::film
