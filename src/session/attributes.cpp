#include "session/attributes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "session/attribute_table.h"
#include "text/error.h"
#include "text/suggest.h"

namespace lamella::session {

using language::Element;
using language::ElementKind;
using Source = AttributeSource;

namespace {

// Text that was parsed before may speak of a column that is no more.
void check_column(const scene::Scene& scene, const AttributeRow& row) {
  const film::Column* const column = columns_of(scene, row.kind).find(row.column);
  if (column != nullptr && column->shape == row.shape) return;
  throw text::Error(fmt::format("{} have no attribute \"{}\" now", language::plural_of(row.kind), row.name));
}

}  // namespace

film::ElementKind film_kind(ElementKind kind) {
  return static_cast<film::ElementKind>(kind);
}

film::Columns& columns_of(scene::Scene& scene, ElementKind kind) {
  return kind == ElementKind::body ? scene.body_columns : scene.film.columns(film_kind(kind));
}

const film::Columns& columns_of(const scene::Scene& scene, ElementKind kind) {
  return kind == ElementKind::body ? scene.body_columns : scene.film.columns(film_kind(kind));
}

Attributes::Attributes() : rows_(built_in_attributes()) {}

std::optional<language::AttributeMeaning> Attributes::find(const scene::Scene& scene, ElementKind kind,
                                                           std::string_view name) {
  const std::string key = text::lower(name);
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const AttributeRow& row = rows_[i];
    if (row.kind == kind && row.name == key && !row.summary.empty())
      return language::AttributeMeaning{{i}, row.shape, row.takes_number};
  }
  for (const AttributeRow& promise : promised_) {
    if (promise.kind == kind && promise.name == key) return user_row(kind, key, promise.shape);
  }
  const film::Column* const column = columns_of(scene, kind).find(key);
  if (column == nullptr) return std::nullopt;
  return user_row(kind, key, column->shape);
}

// The row of a column of the user's; one for each shape that it ever had.
language::AttributeMeaning Attributes::user_row(ElementKind kind, const std::string& name,
                                                const std::vector<int>& shape) {
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const AttributeRow& row = rows_[i];
    if (row.kind == kind && row.name == name && row.shape == shape) return {{i}, shape};
  }
  rows_.push_back({kind, name, {}, name, shape, nullptr, nullptr, nullptr, false});
  return {{static_cast<std::uint32_t>(rows_.size() - 1)}, shape};
}

void Attributes::promise(ElementKind kind, std::string_view name, std::vector<int> shape) {
  promised_.push_back({kind, text::lower(name), {}, {}, std::move(shape), nullptr, nullptr, nullptr, false});
}

std::string Attributes::summary(ElementKind kind, std::string_view name) const {
  const std::string key = text::lower(name);
  const auto at = std::find_if(rows_.begin(), rows_.end(),
                               [&](const AttributeRow& row) { return row.kind == kind && row.name == key; });
  return at == rows_.end() ? std::string{} : at->summary;
}

void Attributes::collect_names(const scene::Scene& scene, ElementKind kind,
                               std::vector<std::string>& into) const {
  for (const AttributeRow& row : rows_) {
    if (row.kind == kind && !row.summary.empty()) into.push_back(row.name);
  }
  columns_of(scene, kind).for_each([&](const film::Column& column) {
    if (std::find(into.begin(), into.end(), column.name) == into.end()) into.push_back(column.name);
  });
}

double Attributes::get(const Source& source, language::AttributeId id, const Element& element,
                       int component) const {
  const AttributeRow& row = rows_[id.row];
  if (row.get != nullptr) return row.get(source, element, component);
  if (row.summary.empty()) check_column(source.scene, row);
  return column_value(source, element, row.column, component);
}

bool Attributes::can_set(language::AttributeId id) const {
  return rows_[id.row].set != nullptr || !rows_[id.row].column.empty();
}

void Attributes::set(const Source& source, language::AttributeId id, const Element& element, int component,
                     double value) const {
  const AttributeRow& row = rows_[id.row];
  if (row.set != nullptr) {
    row.set(source, element, component, value);
    return;
  }
  if (row.column.empty()) {
    throw text::Error(fmt::format("{} of {} follows from the film and cannot be set", row.name,
                                  language::plural_of(row.kind)));
  }
  if (!std::isfinite(value)) throw text::Error(fmt::format("{} cannot be {}", row.name, value));
  if (row.column == "color") checked_color(value);
  if (datafile::known_column(film_kind(row.kind), row.column) != nullptr) {
    made_column(source, row.kind, row.column).set(element.row, 0, value);
    return;
  }
  check_column(source.scene, row);
  columns_of(source.scene, row.kind).edit(row.column)->set(element.row, component, value);
}

void Attributes::unset(const Source& source, language::AttributeId id, const Element& element,
                       int component) const {
  const AttributeRow& row = rows_[id.row];
  if (row.unset != nullptr) {
    row.unset(source, element, component);
    return;
  }
  if (row.column.empty()) {
    throw text::Error(fmt::format("{} of {} cannot be unset", row.name, language::plural_of(row.kind)));
  }
  if (film::Column* const column = columns_of(source.scene, row.kind).edit(row.column))
    column->set(element.row, 0, column->blank);
}

}  // namespace lamella::session
