// The link of a vertex, or of a cluster of vertices seen as one: what its films draw on a small sphere around
// it.
//
// Nodes are the edges that leave the cluster, arcs the facets with one corner in it; the arcs part the sphere
// into sectors. All of it follows from the stored order of films around edges, by counting alone: regions do
// not matter, and neither does geometry. Two edges that a facet of the cluster joins (to vanish when the
// cluster shrinks to a point) are one node.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "film/film.h"

namespace lamella::surgery {

struct Link {
  // A facet (at, outer of node[0], outer of node[1]), turning so.
  struct Arc {
    film::Triangle facet;
    film::Vertex at;          // its corner in the cluster
    std::array<int, 2> node;  // indices
    int front = 0;            // sectors
    int behind = 0;
    bool operator==(const Arc&) const = default;
  };
  struct ArcEnd {
    int arc = 0;
    int end = 0;
  };
  struct Node {
    film::Vertex outer;
    std::vector<ArcEnd> ends;  // counterclockwise about the direction outward
    int component = 0;
    int degree() const { return static_cast<int>(ends.size()); }
  };
  struct Sector {
    film::Region region;
    std::vector<int> arcs;  // that it borders
  };

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<Sector> sectors;         // of all components; the space outside of several is counted in each
  std::vector<film::Triangle> inside;  // facets with two or three corners in the cluster
  int components = 0;
  bool has_wires = false;  // an edge without facets leaves the cluster
  bool sound = true;       // rings close, and the labels of each sector agree

  // The sectors met next, counterclockwise about the node's direction, after and before an arc's end.
  int after(ArcEnd e) const { return e.end == 0 ? arcs[index(e.arc)].front : arcs[index(e.arc)].behind; }
  int before(ArcEnd e) const { return e.end == 0 ? arcs[index(e.arc)].behind : arcs[index(e.arc)].front; }

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
};

Link link_of(const film::Film& film, std::span<const film::Vertex> cluster);
Link link_of(const film::Film& film, film::Vertex v);

// What a soap film can have at a point (J. Taylor, Annals of Mathematics 103, 1976), and what it cannot.
enum class LinkKind {
  empty,        // no film
  disc,         // inside a film
  rim,          // on the free edge of a film
  triple,       // on a Plateau border
  tetrahedral,  // where four borders meet
  illegal,      // anything else
};

LinkKind kind_of(const Link& link);

}  // namespace lamella::surgery
