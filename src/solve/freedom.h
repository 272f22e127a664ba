// Which motions of a vertex change the shape of the film, and which only slide the mesh along it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "film/film.h"

namespace lamella::solve {

using film::Vec3;

// Full freedom lets every vertex move anywhere: then a minimum of the discrete energy may tear the mesh into
// slivers, for gains far below the discretisation error. Normal freedom holds what is mere reparametrisation:
// inside a film a vertex moves along the film's normal, on a border or rim square to the line; quad points
// and other corners move freely.
enum class MotionKind { normal, full };

class Freedom {
 public:
  // Directions at x; they stay until renewed.
  Freedom(const film::Film& film, MotionKind kind);
  void renew(std::span<const Vec3> x);

  // Takes out of a field (a row a vertex) what the vertices are not free to do.
  void restrict(std::span<Vec3> field) const;

  // The direction along a border or rim in which a vertex would only slide, if it lies on one.
  std::optional<Vec3> along_line(std::size_t vertex) const;
  // The normal of the film at a vertex of a rim that a constraint holds.
  std::optional<Vec3> sliding_normal(std::size_t vertex) const;

  // What is left to a vertex: so many directions, however the film lies, and at the last `renew` these
  // (orthonormal; the rest of the three is to be ignored).
  std::uint32_t count(std::size_t vertex) const;
  std::array<Vec3, 3> directions(std::size_t vertex) const;

 private:
  enum class Kind : std::uint8_t { free, along, square, slides };
  struct Line {
    std::uint32_t vertex = 0;
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    Vec3 shift;  // of `after` against `before` in a periodic film
  };
  film::Film film_;
  std::vector<Kind> kind_;
  std::vector<Line> lines_;
  std::vector<Vec3> direction_;
};

}  // namespace lamella::solve
