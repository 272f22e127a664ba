#include "language/elements.h"

#include <array>
#include <utility>

#include "text/suggest.h"

namespace lamella::language {

namespace {

struct Names {
  std::string_view singular;
  std::string_view plural;
};

constexpr std::array<Names, 4> names = {
    {{"vertex", "vertices"}, {"edge", "edges"}, {"facet", "facets"}, {"body", "bodies"}}};

}  // namespace

std::optional<ElementKind> element_kind(std::string_view word) {
  const std::string key = text::lower(word);
  for (std::size_t kind = 0; kind < names.size(); ++kind) {
    if (key == names[kind].singular || key == names[kind].plural) return static_cast<ElementKind>(kind);
  }
  if (key == "face" || key == "faces") return ElementKind::facet;
  return std::nullopt;
}

std::string_view name_of(ElementKind kind) {
  return names[static_cast<std::size_t>(kind)].singular;
}

std::string_view plural_of(ElementKind kind) {
  return names[static_cast<std::size_t>(kind)].plural;
}

}  // namespace lamella::language
