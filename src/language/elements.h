// Elements of a scene as the language sees them: a kind and a row.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace lamella::language {

enum class ElementKind : std::uint8_t { vertex, edge, facet, body };
inline constexpr ElementKind element_kinds[] = {ElementKind::vertex, ElementKind::edge, ElementKind::facet,
                                                ElementKind::body};

// `vertex`, `vertices`, `face` and so on, in any case.
std::optional<ElementKind> element_kind(std::string_view word);
std::string_view name_of(ElementKind kind);
std::string_view plural_of(ElementKind kind);

// One element, in the orientation in which it was met.
struct Element {
  ElementKind kind = ElementKind::vertex;
  std::uint32_t row = 0;  // body b has row b-1
  bool reversed = false;

  friend constexpr auto operator<=>(const Element&, const Element&) = default;
};

}  // namespace lamella::language
