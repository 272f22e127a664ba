#include "picture/film_copy.h"

namespace lamella::picture {

namespace {

using film::ElementKind;

void copy_column(film::Film& copy, const film::Film& original, ElementKind kind, std::string_view name,
                 const std::vector<std::uint32_t>& rows) {
  const film::Column* const from = original.columns(kind).find(name);
  if (from == nullptr) return;
  film::Column column = *from;
  column.resize(0);
  film::Column& to = copy.columns(kind).add(std::move(column));
  for (std::uint32_t row = 0; row < rows.size(); ++row) to.copy_row_of(*from, rows[row], row);
}

template <class T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<std::uint32_t>& rows) {
  std::vector<T> result;
  if (values.empty()) return result;
  result.reserve(rows.size());
  for (const std::uint32_t row : rows) result.push_back(values[row]);
  return result;
}

}  // namespace

void finish_copy(FilmCopy& copy, const film::Film& original, const Content& content, const CopiedRows& rows) {
  film::Film& film = copy.scene.film;
  film.columns_follow_rows();
  copy_column(film, original, ElementKind::facet, "color", rows.triangles);
  copy_column(film, original, ElementKind::facet, "backcolor", rows.triangles);
  copy_column(film, original, ElementKind::facet, "nodisplay", rows.triangles);
  copy_column(film, original, ElementKind::edge, "color", rows.edges);
  copy_column(film, original, ElementKind::edge, "fixed", rows.edges);
  copy_column(film, original, ElementKind::vertex, "fixed", rows.vertices);
  film.sort_all_sides();
  copy.content = content;
  copy.content.facets = picked(content.facets, rows.triangles);
  copy.content.thickness = picked(content.thickness, rows.vertices);
  if (!content.field) return;
  const bool of_facets = content.field->of == ElementKind::facet;
  copy.content.field->values = picked(content.field->values, of_facets ? rows.triangles : rows.vertices);
}

}  // namespace lamella::picture
