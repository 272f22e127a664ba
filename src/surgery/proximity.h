// Sheets of a film that come near one another: vertices and facets that are no neighbours.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"
#include "surgery/facet_gap.h"

namespace lamella::surgery {

struct NearPair {
  film::Vertex vertex;
  film::Triangle facet;

  friend auto operator<=>(const NearPair&, const NearPair&) = default;
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
  // Lengths in units of the size at the vertex (surgery/sizing.h): what touches, and how much farther off two
  // may be and still be near.
  Proximity(double reach, double margin) : reach_(reach), margin_(margin) {}

  // The vertices and facets that are near one another, of pairs of facets that may be
  // (surgery/tangle_watch.h). The margin is taken of the smaller size.
  void update(const film::Film& film, std::span<const FacetPair> facets);
  bool empty() const { return pairs_.empty(); }
  // Whether the list belongs to this film, not to what it was before surgery.
  bool belongs_to(const film::Film& film) const { return connectivity_ == film.connectivity_revision(); }
  std::span<const NearPair> pairs() const { return pairs_; }
  // Those that touched when the list was made, nearest first.
  std::span<const Contact> contacts() const { return contacts_; }

 private:
  double reach_;
  double margin_;
  std::uint64_t connectivity_ = 0;
  std::vector<NearPair> pairs_;
  std::vector<Contact> contacts_;
};

}  // namespace lamella::surgery
