#include "datafile/attributes.h"

#include <algorithm>
#include <array>

#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;
using New = film::Inheritance::New;
using Type = KnownColumn::Type;

constexpr double black = 0;
constexpr double white = 15;

// What splits a fixed edge is fixed, what is drawn inside a fixed facet too; so with no_refine and bare.
constexpr std::array<KnownColumn, 20> column_table = {{
    {ElementKind::vertex, "fixed", Type::flag, 0, New::parent},
    {ElementKind::vertex, "bare", Type::flag, 0, New::parent},
    {ElementKind::vertex, "original", Type::integer, 0, New::blank},
    {ElementKind::edge, "tension", Type::real, 0, New::blank},
    {ElementKind::edge, "fixed", Type::flag, 0, New::parent},
    {ElementKind::edge, "bare", Type::flag, 0, New::blank},
    {ElementKind::edge, "no_refine", Type::flag, 0, New::parent},
    {ElementKind::edge, "color", Type::integer, black, New::blank},
    {ElementKind::edge, "orientation", Type::integer, 1, New::blank},
    {ElementKind::edge, "original", Type::integer, 0, New::blank},
    {ElementKind::facet, "tension", Type::real, 1, New::blank},
    {ElementKind::facet, "fixed", Type::flag, 0, New::blank},
    {ElementKind::facet, "no_refine", Type::flag, 0, New::blank},
    {ElementKind::facet, "nodisplay", Type::flag, 0, New::blank},
    {ElementKind::facet, "color", Type::integer, white, New::blank},
    {ElementKind::facet, "backcolor", Type::integer, white, New::blank},
    {ElementKind::facet, "opacity", Type::real, 1, New::blank},
    {ElementKind::facet, "orientation", Type::integer, 1, New::blank},
    {ElementKind::facet, "original", Type::integer, 0, New::blank},
    {ElementKind::body, "original", Type::integer, 0, New::blank},
}};

constexpr std::array<CarriedColumn, 6> carried_table = {{
    {ElementKind::vertex, "velocity", 3, New::mean},
    {ElementKind::vertex, "mass", 1, New::blank},
    {ElementKind::vertex, "mesh_size", 1, New::mean, 0, film::Inheritance::Merge::mean},
    {ElementKind::vertex, "swept_place", 3, New::blank},
    {ElementKind::body, "volume_defect", 4, New::blank, 3},
    {ElementKind::body, "swept_mark", 1, New::blank},
}};

constexpr std::array<AttributeWord, 27> word_table = {{
    {"fixed", "vef", AttributeAction::flag, "fixed"},
    {"bare", "ve", AttributeAction::flag, "bare"},
    {"no_refine", "ef", AttributeAction::flag, "no_refine"},
    {"nodisplay", "f", AttributeAction::flag, "nodisplay"},
    {"tension", "ef", AttributeAction::number, "tension"},
    {"density", "ef", AttributeAction::number, "tension"},
    {"color", "e", AttributeAction::whole, "color"},
    {"color", "f", AttributeAction::both_colors, "color"},
    {"frontcolor", "f", AttributeAction::whole, "color"},
    {"backcolor", "f", AttributeAction::whole, "backcolor"},
    {"opacity", "f", AttributeAction::number, "opacity"},
    {"original", "vefb", AttributeAction::original, "original"},
    {"volume", "b", AttributeAction::volume, {}},
    {"pressure", "b", AttributeAction::pressure, {}},
    {"density", "b", AttributeAction::density, {}},
    {"volconst", "b", AttributeAction::volume_constant, {}},
    {"actual_volume", "b", AttributeAction::actual_volume, {}},
    {"lagrange_multiplier", "b", AttributeAction::multiplier, {}},
    {"centerofmass", "b", AttributeAction::nothing, {}},
    {"constraint", "vef", AttributeAction::constraint, {}},
    {"constraints", "vef", AttributeAction::constraint, {}},
    {"boundary", "vef", AttributeAction::boundary, {}},
    {"orientation", "ef", AttributeAction::orientation, {}},
    {"phase", "fb", AttributeAction::phase, {}},
    {"wrap", "e", AttributeAction::wrap, {}},
    {"axial_point", "v", AttributeAction::refused, "symmetry groups"},
    {"noncontent", "vef", AttributeAction::refused, "elements that do not count in volumes"},
}};

constexpr std::array<ElementKind, 4> kinds = {ElementKind::vertex, ElementKind::edge, ElementKind::facet,
                                              ElementKind::body};

char letter(ElementKind kind) {
  return film::name_of(kind).front();
}

}  // namespace

std::span<const KnownColumn> known_columns() {
  return column_table;
}

const KnownColumn* known_column(ElementKind kind, std::string_view name) {
  const auto at = std::find_if(column_table.begin(), column_table.end(), [&](const KnownColumn& column) {
    return column.kind == kind && column.name == name;
  });
  return at == column_table.end() ? nullptr : &*at;
}

film::Column make_column(const KnownColumn& known) {
  const std::string name(known.name);
  switch (known.type) {
    case Type::flag:
      return film::flag_column(name, known.on_new);
    case Type::integer:
      return film::integer_column(name, static_cast<int>(known.blank), known.on_new);
    case Type::real:
      return film::real_column(name, known.blank, 1, known.on_new);
  }
  return {};
}

std::span<const CarriedColumn> carried_columns() {
  return carried_table;
}

const CarriedColumn* carried_column(ElementKind kind, std::string_view name) {
  const auto at = std::find_if(carried_table.begin(), carried_table.end(), [&](const CarriedColumn& column) {
    return column.kind == kind && column.name == name;
  });
  return at == carried_table.end() ? nullptr : &*at;
}

film::Column declared_column(ElementKind kind, std::string name, bool integer, std::vector<int> shape) {
  if (const CarriedColumn* carried = carried_column(kind, name)) {
    film::Column column = film::real_column(std::move(name), 0, carried->width, carried->on_new);
    column.inheritance.on_merge = carried->on_merge;
    return column;
  }
  film::Column column;
  column.name = std::move(name);
  column.shape = std::move(shape);
  for (const int size : column.shape) column.width *= size;
  column.user_defined = true;
  if (integer) {
    column.data = film::Integers{};
  } else {
    column.data = film::Reals{};
  }
  return column;
}

std::span<const AttributeWord> attribute_words() {
  return word_table;
}

const AttributeWord* attribute_word(ElementKind kind, std::string_view word) {
  const std::string key = text::lower(word);
  const auto at = std::find_if(word_table.begin(), word_table.end(), [&](const AttributeWord& attribute) {
    return attribute.word == key && attribute.kinds.find(letter(kind)) != std::string_view::npos;
  });
  return at == word_table.end() ? nullptr : &*at;
}

bool is_attribute_word(std::string_view word) {
  const std::string key = text::lower(word);
  return std::any_of(word_table.begin(), word_table.end(),
                     [&](const AttributeWord& attribute) { return attribute.word == key; });
}

std::string kinds_with_attribute(std::string_view word) {
  std::string result;
  for (const ElementKind kind : kinds) {
    if (attribute_word(kind, word) == nullptr) continue;
    result += result.empty() ? "" : " and ";
    result += element_plural(kind);
  }
  return result;
}

std::string_view element_name(ElementKind kind) {
  return kind == ElementKind::facet ? "face" : film::name_of(kind);
}

std::string_view element_plural(ElementKind kind) {
  constexpr std::array<std::string_view, 4> plurals = {"vertices", "edges", "faces", "bodies"};
  return plurals[static_cast<std::size_t>(kind)];
}

}  // namespace lamella::datafile
