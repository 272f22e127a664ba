// Whether a film in motion has come to pass through itself, asked again and again.
//
// Two facets that are a gap s apart cannot meet before their vertices have moved s together. So pairs of
// facets that come near one another are listed, each with its gap, and each facet may go a way from where it
// was listed before that is done anew: of a film that hardly moves, or swings, next to nothing is looked at.
// Of pairs whose gap is used up, the way since the last look is followed, too, taken as straight: they may
// not pass through one another between two looks and come out on the other side.
//
// Facets that share a vertex are looked at when their edges have changed. Where a vertex lies inside a sheet
// that is flat around it, they cannot meet as long as no normal has turned too far; elsewhere pairs of them
// are kept apart by a plane through the vertex. Facets of one flat sheet that are neighbours of neighbours
// are not listed either.
#pragma once

#include <span>
#include <vector>

#include "film/facet_cells.h"
#include "film/film.h"
#include "surgery/facet_gap.h"
#include "surgery/tangle.h"

namespace lamella::surgery {

class TangleWatch {
 public:
  // What tangles(film) finds in a compact film, and what has met since the last call that found nothing.
  // `reaches`, where given, is how far each vertex has been from its place at that call.
  std::vector<Tangle> look(const film::Film& film, std::span<const double> reaches = {});
  // After surgery, before rows move: what is known of facets that stay is kept.
  void before_compaction(const film::Film& film);
  // The film was put elsewhere, or it is not sound: how it came there does not count.
  void forget() {
    corners_.clear();
    pairs_.clear();
  }
  // Whether it has a film to go on from.
  bool knows_film() const { return !corners_.empty(); }
  // Pairs as of the last call, in no particular order. A facet that is nearer to another than `listed_reach`
  // times the size of one of its vertices is in a pair with it, unless they share a vertex or lie in one flat
  // sheet.
  std::span<const FacetPair> near_pairs() const { return pairs_; }
  static constexpr double listed_reach = 0.15;
  // Whether the last call was about a film as it is now.
  bool has_looked_at(const film::Film& film) const {
    return positions_ == film.position_revision() && connectivity_ == film.connectivity_revision();
  }
  // Facets that were looked at, over all calls.
  long looked_at() const { return looked_at_; }

 private:
  bool adopt(const film::Film& film);
  void spend(const film::Film& film, std::span<const double> reaches);
  double way_left(film::Triangle t) const;
  bool has_turned(const film::Film& film, film::Triangle t) const;
  void choose(const film::Film& film);
  void look_at_all_again();
  void look_around(const film::Film& film, std::vector<Tangle>& found);
  void look_at_vertex(const film::Film& film, film::Vertex v);
  bool find_flat(const film::Film& film, film::Vertex v);
  void compare_at_corner(const film::Film& film, film::Triangle t, film::Triangle other,
                         std::vector<Tangle>& found);
  void look_at_borders(const film::Film& film, std::vector<Tangle>& found);
  void list_anew(const film::Film& film);
  void list(const film::Film& film, film::Triangle t);
  void stamp_ring(const film::Film& film, film::Triangle t);
  bool is_neighbour(film::Triangle other) const;
  void look_at_pairs(const film::Film& film, std::vector<Tangle>& found);
  bool have_met(const film::Film& film, film::Triangle t, film::Triangle other) const;

  std::vector<std::array<film::Vertex, 3>> corners_;
  std::vector<double> edges_;       // by how much the edges of a facet may change before it is looked at
  std::vector<Corners> listed_at_;  // where facets were when what is near them was listed
  std::vector<double> listed_for_;  // how far from there the list serves
  std::vector<FacetPair> pairs_;
  std::vector<std::uint8_t> flat_;  // vertices around which the sheet is flat
  std::vector<film::Vec3> last_;    // where vertices were at the last call that found nothing
  std::vector<double> reach_;       // how far they have been from there
  std::vector<double> way_;         // the same of facets
  struct Due {
    bool edges = false;
    bool way = false;
  };
  std::vector<Due> due_;  // which facets are looked at, and for what
  std::vector<film::Triangle> stretched_;
  std::vector<film::Triangle> moved_;
  std::vector<film::Edge> borders_;
  film::FacetCells cells_;
  std::vector<film::Box> asked_;      // of those that moved, widened
  std::vector<std::uint32_t> stamp_;  // of vertices: what they were met for last
  std::uint32_t stamps_ = 0;
  struct Ring {
    film::Triangle facet;
    film::Vec3 to;  // from the vertex to the corner by which a walk around it comes to the facet
  };
  std::vector<Ring> ring_;
  std::uint64_t positions_ = 0;  // of the film at the last call
  std::uint64_t connectivity_ = 0;
  bool goes_on_ = true;  // the last call found nothing
  long looked_at_ = 0;
};

}  // namespace lamella::surgery
