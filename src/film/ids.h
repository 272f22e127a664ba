// Typed 32-bit indices of a film's elements: a Vertex cannot be taken for an Edge.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace lamella::film {

inline constexpr std::uint32_t no_index = 0xffffffffU;

template <class Tag>
struct Id {
  std::uint32_t index = no_index;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t i) : index(i) {}
  constexpr explicit Id(std::size_t i) : index(static_cast<std::uint32_t>(i)) {}

  constexpr bool valid() const { return index != no_index; }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using Vertex = Id<struct VertexTag>;
using Edge = Id<struct EdgeTag>;
using Triangle = Id<struct TriangleTag>;

// A region of space that films bound. Region 0 is the outside, and whatever no body claims; body b of a
// datafile is region b.
struct Region {
  std::uint32_t index = 0;

  constexpr bool outside() const { return index == 0; }
  friend constexpr auto operator<=>(const Region&, const Region&) = default;
};

inline constexpr Region outside_region{};

// A side of a triangle (a facet-edge): side k of triangle t runs from its corner k to corner k+1.
struct Side {
  std::uint32_t index = no_index;

  constexpr Side() = default;
  constexpr explicit Side(std::uint32_t i) : index(i) {}
  constexpr Side(Triangle t, int corner) : index(3 * t.index + static_cast<std::uint32_t>(corner)) {}

  constexpr bool valid() const { return index != no_index; }
  constexpr Triangle triangle() const { return Triangle(index / 3); }
  constexpr int corner() const { return static_cast<int>(index % 3); }
  friend constexpr auto operator<=>(const Side&, const Side&) = default;
};

constexpr int next_corner(int k) {
  return k == 2 ? 0 : k + 1;
}
constexpr int previous_corner(int k) {
  return k == 0 ? 2 : k - 1;
}

// An edge walked along its direction or against it: the datafile's 5 or -5.
struct SignedEdge {
  std::uint32_t code = no_index;  // twice the edge's index, plus one if reversed

  constexpr SignedEdge() = default;
  constexpr SignedEdge(Edge e, bool is_reversed) : code(2 * e.index + (is_reversed ? 1U : 0U)) {}

  constexpr bool valid() const { return code != no_index; }
  constexpr Edge edge() const { return Edge(code / 2); }
  constexpr bool reversed() const { return (code & 1U) != 0; }
  constexpr SignedEdge operator-() const { return SignedEdge(edge(), !reversed()); }
  friend constexpr auto operator<=>(const SignedEdge&, const SignedEdge&) = default;
};

// What lies on the two sides of a triangle. Its normal, by the right-hand rule from the order of its
// corners, points into `front` and away from `behind`. A datafile's body lists a facet as +f where the
// body is behind it (normal outward) and as -f where it is in front.
struct RegionPair {
  Region front;
  Region behind;

  constexpr RegionPair flipped() const { return {behind, front}; }
  friend constexpr bool operator==(const RegionPair&, const RegionPair&) = default;
};

}  // namespace lamella::film
