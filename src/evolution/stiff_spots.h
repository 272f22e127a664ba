// A closer bound on the frequencies of a film whose stiffest vertices are few, as where a mesh has slivers.
#pragma once

#include <span>
#include <vector>

#include "energy/sweep.h"
#include "film/film.h"

namespace lamella::evolution {

using film::Vec3;

// A triangle's stiffness K (3x3, energy/sweep.h) lies below k diag(d) for whatever positive numbers d at its
// corners, k the largest eigenvalue of K relative to diag(d). So with a number d_v for each vertex and s_v =
// d_v * (sum of tension * k around v), the bound omega^2 <= max s_v/m_v holds as it does for the sweep's
// sums, which have d = 1 everywhere. A smaller d makes the sum of its vertex smaller and those of its
// neighbours larger: where the stiffest vertex is stiffer than its neighbours, they take some of it over.
class StiffSpots {
 public:
  struct Mesh {
    const film::Film& film;
    std::span<const std::array<film::Vertex, 3>> triangles;  // rows of `positions`
    std::span<const Vec3> positions;
    std::span<const double> tension;            // one a triangle, or empty for 1 everywhere
    std::span<const energy::VertexLine> lines;  // by vertex, of a sweep at these positions
    std::span<const double> weights;            // 1/m by vertex, 0 for those that stay
  };

  // Vertices beyond this part of the largest s/m are spots; the bound does not fall below it.
  static constexpr double watched = 0.75;
  // A film that has more of them is stiff everywhere.
  static constexpr std::size_t most = 64;

  // A bound on omega^2, given the largest s/m of the sweep's sums and all spots, in ascending order.
  double relieve(const Mesh& mesh, std::span<const film::Vertex> spots, double largest);

 private:
  struct State {
    double rate = 0;  // s/m
    double d = 0;     // 0 where nobody has looked
  };
  // A triangle around the vertex at hand.
  struct Piece {
    std::uint32_t triangle = 0;
    std::array<film::Vertex, 3> corners;
    std::array<double, 3> diagonal{};  // of K
    double tension = 1;
  };
  void touch(const Mesh& mesh, film::Vertex v);
  film::Vertex stiffest() const;
  void find_star(const Mesh& mesh, film::Vertex v);
  void add_star(const Mesh& mesh, double sign);
  bool relieve_one(const Mesh& mesh, film::Vertex v);

  std::vector<State> states_;          // by vertex
  std::vector<film::Vertex> touched_;  // those whose state is not that of the start
  std::vector<Piece> star_;
  std::vector<double> rates_before_;  // of the star's corners, triangle by triangle
};

}  // namespace lamella::evolution
