#include "scene/cells.h"

#include <algorithm>
#include <cstdlib>

#include "language/formula_scope.h"
#include "language/lexer.h"
#include "scene/scene.h"

namespace lamella::scene {

namespace {

language::Formula formula(const char* text) {
  const text::SourcePointer source = text::make_source("cell", text);
  language::LexerStream tokens(language::Lexer(source, language::LexerMode::datafile));
  return language::parse_formula(tokens, language::FormulaKind::space, {}, {});
}

}  // namespace

StringModel make_string_model() {
  StringModel model;
  model.area[0] = formula("-y");
  model.height[0] = formula("-y*y/2");
  return model;
}

std::vector<std::vector<film::SignedEdge>> loops_of_cells(const Scene& scene) {
  std::vector<std::vector<film::SignedEdge>> loops(scene.strings.cells.size());
  const film::Film& film = scene.film;
  const film::Column* const column = film.columns(film::ElementKind::edge).find(cells_column);
  for (std::uint32_t row = 0; column != nullptr && row < film.edge_rows(); ++row) {
    if (!film.alive(film::Edge(row))) continue;
    for (int k = 0; k < column->width; ++k) {
      const int cell = static_cast<int>(column->value(row, k));
      if (cell != 0)
        loops[static_cast<std::size_t>(std::abs(cell)) - 1].emplace_back(film::Edge(row), cell < 0);
    }
  }
  for (std::vector<film::SignedEdge>& loop : loops) {
    for (auto at = loop.begin(); at != loop.end() && at + 1 != loop.end(); ++at) {
      const auto follows = [&](film::SignedEdge e) { return film.tail(e) == film.head(*at); };
      auto next =
          std::find_if(at + 1, loop.end(), [&](film::SignedEdge e) { return follows(e) && e != -*at; });
      if (next == loop.end()) next = std::find_if(at + 1, loop.end(), follows);
      if (next != loop.end()) std::iter_swap(at + 1, next);
    }
  }
  return loops;
}

}  // namespace lamella::scene
