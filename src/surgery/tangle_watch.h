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

#include <cmath>
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
  // times the size of one of its vertices is in a pair with it, unless they share a vertex, lie in one flat
  // sheet, or in one sheet between two regions with normals that are within 85 degrees.
  std::span<const FacetPair> near_pairs() const { return pairs_; }
  static constexpr double listed_reach = 0.15;
  // Whether the last call was about a film as it is now.
  bool has_looked_at(const film::Film& film) const {
    return positions_ == film.position_revision() && connectivity_ == film.connectivity_revision();
  }
  // Facets that were looked at, over all calls.
  long looked_at() const { return looked_at_; }

 private:
  // What the sheet is like around a vertex: that it is none stays so until facets are made there.
  enum class Around : std::uint8_t { no_sheet, rough, flat };
  static constexpr double turned_cosine = 0.17;
  static constexpr double unknown = -HUGE_VAL;  // of edges of facets that were made or changed
  bool adopt(const film::Film& film);
  void measure_reach(const film::Film& film, std::span<const double> reaches);
  double edge_change(const film::Film& film, film::Triangle t) const;
  bool is_spent(film::Triangle t) const;
  void spend(const film::Film& film, film::Triangle t);
  bool is_far(film::Triangle t, double size) const;
  void choose(const film::Film& film, std::span<const double> reaches);
  void spend_on_surgery(const film::Film& film);
  void go_back(const film::Film& film);
  void look_around(const film::Film& film, std::vector<Tangle>& found);
  void look_at_vertices(const film::Film& film);
  void look_at_vertex(const film::Film& film, film::Vertex v);
  Around look_around(const film::Film& film, film::Vertex v);
  bool is_flat(film::Vertex v) const { return around_[v.index] == Around::flat; }
  // Whether a facet at a flat vertex has come near to turning by a right angle (80 degrees).
  bool has_turned_over(film::Vertex v, const film::Vec3& normal) const {
    const std::array<float, 3>& axis = axes_[v.index];
    const double along = normal.x * axis[0] + normal.y * axis[1] + normal.z * axis[2];
    return is_flat(v) &&
           !(along > 0 && along * along > turned_cosine * turned_cosine * squared_length(normal));
  }
  void compare_at_corner(const film::Film& film, film::Triangle t, film::Triangle other,
                         std::vector<Tangle>& found);
  void look_at_borders(const film::Film& film, std::vector<Tangle>& found);
  void list_anew(const film::Film& film, std::vector<Tangle>& found);
  void make_cells(const film::Film& film);
  void put(const film::Film& film, film::Triangle t);
  bool cannot_meet(const film::Film& film, const FacetPair& pair) const;
  void list(const film::Film& film, film::Triangle t, double times);
  void list_near(const film::Film& film, film::Triangle t, std::vector<Tangle>& found);
  void stamp_ring(const film::Film& film, film::Triangle t);
  bool is_neighbour(film::Triangle t, film::Triangle other) const;
  void look_at_pairs(const film::Film& film, std::vector<Tangle>& found);
  void look_at_pair(const film::Film& film, FacetPair& pair, std::vector<Tangle>& found);
  bool have_met(const film::Film& film, const FacetPair& pair) const;

  std::vector<std::array<film::Vertex, 3>> corners_;
  std::vector<double> edges_;        // by how much the edges of a facet may change before it is looked at
  std::vector<Corners> listed_at_;   // where facets were when what is near them was listed
  std::vector<double> listed_for_;   // how far from there the list serves
  std::vector<std::uint8_t> alone_;  // nothing but their own smooth sheets was near them
  std::vector<FacetPair> pairs_;
  std::vector<Around> around_;              // of vertices
  std::vector<std::array<float, 3>> axes_;  // around which flat ones are flat
  std::vector<film::Vec3> last_;            // where vertices were at the last call that found nothing
  std::vector<double> reach_;               // how far they have been from there
  std::vector<double> way_;                 // the same of facets
  struct Due {
    bool edges = false;
    bool way = false;
  };
  std::vector<Due> due_;  // which facets are looked at, and for what
  std::vector<film::Triangle> stretched_;
  std::vector<film::Triangle> moved_;
  std::vector<film::Vertex> unsure_;  // that may be flat no longer
  std::vector<film::Edge> borders_;
  std::vector<std::size_t> measured_;  // pairs whose gap is that of the last call
  film::FacetCells cells_;
  std::vector<std::uint32_t> stamp_;  // of vertices: what they were met for last
  std::uint32_t stamps_ = 0;
  std::vector<film::Vec3> ring_;  // ways from a vertex to those around it
  std::uint64_t positions_ = 0;   // of the film at the last call
  std::uint64_t connectivity_ = 0;
  long looked_at_ = 0;
};

}  // namespace lamella::surgery
