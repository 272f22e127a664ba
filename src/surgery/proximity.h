// Sheets of a film that come near one another: vertices and facets that are no neighbours.
//
// The list is made with a margin and kept while the film moves: as long as no vertex has moved by half the
// margin, no pair nearer than the reach is missing. On a film whose sheets keep apart it is empty.
#pragma once

#include <span>
#include <vector>

#include "film/facet_cells.h"
#include "scene/scene.h"

namespace lamella::surgery {

struct NearPair {
  film::Vertex vertex;
  film::Triangle facet;
};

struct Contact {
  NearPair pair;
  double distance = 0;
  film::Vec3 place;    // of the nearest point of the facet
  bool wedge = false;  // on films that meet at a border near by
};

// The point of a triangle nearest to another.
film::Vec3 nearest_point(const std::array<film::Vec3, 3>& triangle, const film::Vec3& p);

class Proximity {
 public:
  // Lengths in units of the size at the vertex (surgery/sizing.h).
  Proximity(double reach, double margin) : reach_(reach), margin_(margin) {}

  // Makes the list anew if it belongs to another film or a vertex has moved too far. `cells` are of the film
  // as it is, or made so.
  void update(const film::Film& film, film::FacetCells& cells);
  bool empty() const { return pairs_.empty(); }
  // Whether the list belongs to this film, not to what it was before surgery.
  bool belongs_to(const film::Film& film) const { return connectivity_ == film.connectivity_revision(); }
  std::span<const NearPair> pairs() const { return pairs_; }
  // Those within reach now, nearest first.
  std::vector<Contact> contacts(const film::Film& film, std::span<const film::Vec3> positions) const;
  long builds() const { return builds_; }

 private:
  void build(const film::Film& film, film::FacetCells& cells);

  double reach_;
  double margin_;
  std::uint64_t connectivity_ = 0;
  std::vector<film::Vec3> built_at_;
  std::vector<double> sizes_;
  std::vector<NearPair> pairs_;
  std::vector<film::Box> asked_;  // around vertices
  std::vector<film::Vertex> askers_;
  long builds_ = 0;
};

}  // namespace lamella::surgery
