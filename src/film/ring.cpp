#include "film/ring.h"

#include <array>

namespace lamella::film {

std::vector<Side> ring_with(const Film& film, Edge edge, Side old, Side made) {
  std::vector<Side> ring;
  film.for_each_side(edge, [&](Side s) { ring.push_back(s == old ? made : s); });
  return ring;
}

void begin_ring(Film& film, Side side) {
  const Edge edge = film.edge_of(side).edge();
  const Side first = film.first_side(edge);
  if (first != side && film.next_around(first) == side && film.next_around(side) == first)
    film.set_ring(edge, std::array{side, first});
}

}  // namespace lamella::film
