// Curvature that sits in angles: at the corners of facets and along edges.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "energy/vertex_star.h"
#include "film/unfolding.h"

namespace lamella::energy {

using film::Vec3;

// A sum of multiples of angles, or of length times angle, with its derivatives. Rows are those of the
// unfolding in a periodic film.
class AngleSums {
 public:
  // Adds `times` the angle of a facet at a corner.
  void add_corner(double times, const std::array<film::Vertex, 3>& rows, std::size_t corner);
  // Adds `times` half the length of an edge times the angle by which the film turns at it: positive where it
  // turns away from the normals of its two facets. Nothing unless the edge has two.
  void add_edge(const film::Film& film, const film::Unfolding& unfolding, film::Edge edge, double times);
  void add_constant(double value) { constant_ += value; }

  bool empty() const { return corners_.empty() && hinges_.empty() && constant_ == 0; }
  double value(std::span<const Vec3> x) const;
  // Adds `factor` times the gradient; returns the value.
  double add_gradient(std::span<const Vec3> x, double factor, std::span<Vec3> gradient) const;
  // Adds `factor` times the second derivatives.
  void add_hessian(std::span<const Vec3> x, double factor, HessianSink& sink) const;
  // Pairs of rows that it couples without an edge between them.
  template <class Function>
  void for_each_far_pair(Function&& function) const {
    for (const Hinge& hinge : hinges_) function(hinge.first[2], hinge.second[2]);
  }
  template <class Function>
  void for_each_row(Function&& function) const {
    for (const Corner& corner : corners_) {
      for (const std::uint32_t row : corner.rows) function(row);
    }
    for (const Hinge& hinge : hinges_) {
      for (const auto& rows : {hinge.first, hinge.second}) {
        for (const std::uint32_t row : rows) function(row);
      }
    }
  }

 private:
  struct Corner {
    std::array<std::uint32_t, 3> rows{};  // the corner itself first
    double times = 1;
  };
  // Tail and head of an edge and the opposite corner, as each of its two facets has them.
  struct Hinge {
    std::array<std::uint32_t, 3> first{};
    std::array<std::uint32_t, 3> second{};
    double times = 1;
  };
  static std::optional<std::array<Vec3, 3>> arms_of(const Hinge& hinge, std::span<const Vec3> x);
  double visit(std::span<const Vec3> x, double factor, std::span<Vec3> gradient) const;

  std::vector<Corner> corners_;
  std::vector<Hinge> hinges_;
  double constant_ = 0;
};

}  // namespace lamella::energy
