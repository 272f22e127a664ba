#include "surgery/equiangulate.h"

#include "surgery/flip.h"

namespace lamella::surgery {

// With edge a and the other sides b, c on one side and d, e on the other, the cosines of the opposite angles
// are (b^2+c^2-a^2)/(2bc) and (d^2+e^2-a^2)/(2de); their sum is negative where the angles exceed pi together.
bool is_worse_diagonal(const film::Film& film, const Diagonal& d) {
  const auto [p, q, r, w] = places(film, d);
  const double cosine_r = dot(unit(p - r), unit(q - r));
  const double cosine_w = dot(unit(p - w), unit(q - w));
  return cosine_r + cosine_w < -1e-10;
}

bool equiangulate(film::Film& film, film::Edge e) {
  const std::optional<Diagonal> diagonal = flippable(film, e);
  if (!diagonal || !is_worse_diagonal(film, *diagonal) || !flip_is_flat(film, *diagonal)) return false;
  flip(film, *diagonal);
  return true;
}

std::uint32_t equiangulate(film::Film& film) {
  std::uint32_t flips = 0;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    if (film.alive(e) && equiangulate(film, e)) ++flips;
  }
  return flips;
}

}  // namespace lamella::surgery
