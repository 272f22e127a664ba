#include "surgery/string_cells.h"

#include <cstdlib>

#include "scene/cells.h"

namespace lamella::surgery {

using film::Column;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;

std::map<int, int> arrivals(const Film& film, std::span<const EdgeEnd> ends) {
  std::map<int, int> net;
  const Column* const cells = film.columns(ElementKind::edge).find(scene::cells_column);
  for (const EdgeEnd end : ends) {
    for (int k = 0; cells != nullptr && k < cells->width; ++k) {
      const int cell = static_cast<int>(cells->value(end.edge().index, k));
      if (cell == 0) continue;
      const bool leaves = (cell > 0) != end.outward().reversed();
      net[std::abs(cell)] += leaves ? -1 : 1;
    }
  }
  return net;
}

void pass_on(Film& film, EdgeEnd from, const std::map<int, int>& arrived) {
  Column* const cells = film.columns(ElementKind::edge).edit(scene::cells_column);
  if (cells == nullptr) return;
  const std::uint32_t row = from.edge().index;
  for (int k = 0; k < cells->width; ++k) cells->set(row, k, 0);
  int slot = 0;
  for (const auto& [cell, excess] : arrived) {
    const bool forward = (excess > 0) != from.outward().reversed();
    if (excess != 0 && slot < cells->width) cells->set(row, slot++, forward ? cell : -cell);
  }
}

}  // namespace lamella::surgery
