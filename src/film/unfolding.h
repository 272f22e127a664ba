// A periodic film as a plain complex in space, for sweeps that know nothing of periods.
//
// Each triangle lies where its first corner is, each edge where its tail is. What they reach beyond their
// cell is a row of its own, the image of a vertex; rows below `vertices` are the vertices themselves. Before
// a sweep `extend` places the images, after it `fold` gives what they have collected to their vertices.
#pragma once

#include <span>
#include <vector>

#include "film/film.h"

namespace lamella::film {

// An edge at which the parts of a region's boundary do not fit, however they are moved by periods: the region
// goes around the whole of space.
struct Seam {
  Vertex from;  // rows, in the direction in which the first of two triangles walks the edge
  Vertex to;
  Vec3 gap;     // by which the second triangle's edge is apart from the first one's
  Vec3 offset;  // of the first triangle
  Region region;
};

// A triangle that has to be moved, for its region's boundary to be in one piece.
struct Apart {
  std::uint32_t triangle = 0;
  Region region;
  Vec3 offset;
  double sign = 1;  // -1 where the region is in front
};

class Unfolding {
 public:
  Unfolding() = default;
  // The film must be periodic and compact.
  explicit Unfolding(const Film& film);

  bool empty() const { return triangles_.empty() && edges_.empty(); }
  std::span<const std::array<Vertex, 3>> triangles() const { return triangles_; }
  std::span<const std::array<Vertex, 2>> edges() const { return edges_; }  // tail, head
  std::size_t rows() const { return vertices_ + images_.size(); }

  // Positions of the vertices, then of the images; written to `into`.
  std::span<const Vec3> extend(std::span<const Vec3> positions, std::vector<Vec3>& into) const;
  // Adds each image's row to its vertex's, and clears it.
  template <class T>
  void fold(std::span<T> rows) const {
    for (std::size_t i = 0; i < images_.size(); ++i) {
      rows[images_[i].of.index] += rows[vertices_ + i];
      rows[vertices_ + i] = T{};
    }
  }
  // The vertex of a row.
  Vertex vertex_of(Vertex row) const {
    return row.index < vertices_ ? row : images_[row.index - vertices_].of;
  }

  // What the sum over triangles, measured from `origin`, lacks for the volumes of regions, at extended
  // positions. They come out up to a multiple of the cell's volume.
  void add_volumes(std::span<const Vec3> extended, const Vec3& origin, std::span<double> volumes) const;

  // What brings the boundary of each region into one piece, as far as that can be: by how many periods to
  // move face 2t, the triangle seen from behind, and 2t + 1, seen from the front. Zero where no region looks
  // at it.
  static std::vector<Wrap> face_offsets(const Film& film);

 private:
  struct Image {
    Vertex of;
    Vec3 shift;
  };
  class Builder;

  std::size_t vertices_ = 0;
  std::vector<std::array<Vertex, 3>> triangles_;
  std::vector<std::array<Vertex, 2>> edges_;
  std::vector<Image> images_;
  std::vector<Apart> apart_;
  std::vector<Seam> seams_;
};

// The corners of a facet at other positions than the film's, unfolded from the first one.
std::array<Vec3, 3> points_at(const Film& film, Triangle t, std::span<const Vec3> positions);

}  // namespace lamella::film
