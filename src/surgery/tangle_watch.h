// Whether a film in motion has come to pass through itself, asked again and again.
//
// Two facets that are a gap s apart cannot meet before their vertices have moved s together. So each facet
// has a way left that it may go before it must be looked at again, and of a film that hardly moves, or moves
// as a whole, next to nothing is. Facets that share a vertex are kept apart by a plane through it: there it
// is the change of their edges that counts. Of facets that are looked at and have no vertex in common, the
// way since the last look is followed, too, taken as straight: they may not pass through one another between
// two looks and come out on the other side.
#pragma once

#include <span>
#include <vector>

#include "film/facet_cells.h"
#include "film/film.h"
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
  void forget() { corners_.clear(); }
  // Whether it has a film to go on from.
  bool knows_film() const { return !corners_.empty(); }
  // What it finds facets by, for others who look for what is near.
  film::FacetCells& cells() { return cells_; }
  // Facets that were looked at, over all calls.
  long looked_at() const { return looked_at_; }

 private:
  // What a facet may do before it must be looked at: change its edges, move.
  struct Left {
    double edges = 0;
    double way = 0;
  };
  bool adopt(const film::Film& film);
  void spend(const film::Film& film, std::span<const double> reaches);
  void look_around(const film::Film& film, film::Triangle t, std::vector<Tangle>& found);
  void compare_at_corner(const film::Film& film, film::Triangle t, film::Triangle other,
                         std::vector<Tangle>& found);
  void look_about(const film::Film& film, std::vector<Tangle>& found);
  const film::Box& box_of(const film::Film& film, film::Triangle t);
  void compare_apart(const film::Film& film, film::Triangle t, film::Triangle other,
                     std::vector<Tangle>& found);
  bool have_met(const film::Film& film, film::Triangle t, film::Triangle other) const;
  void note(const film::Film& film, film::Triangle t, film::Triangle other, std::vector<Tangle>& found);

  std::vector<std::array<film::Vertex, 3>> corners_;
  std::vector<Left> left_;
  std::vector<Left> before_;      // at the last call that found nothing
  std::vector<film::Vec3> last_;  // where vertices were at the last call
  std::vector<double> reach_;     // how far they have been from there
  struct Due {
    bool edges = false;
    bool way = false;
  };
  std::vector<Due> due_;  // which facets are looked at, and for what
  std::vector<film::Triangle> stretched_;
  std::vector<film::Triangle> moved_;
  std::vector<film::Edge> borders_;
  film::FacetCells cells_;
  std::vector<film::Box> boxes_;      // widened, those that were needed in this call
  std::vector<std::uint32_t> boxed_;  // the call that made them
  std::uint32_t call_ = 0;
  std::vector<film::Box> asked_;  // of those that moved, widened
  long looked_at_ = 0;
};

}  // namespace lamella::surgery
