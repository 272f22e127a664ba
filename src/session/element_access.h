// The film's elements as the language sees them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "language/elements.h"
#include "scene/scene.h"

namespace lamella::session {

std::uint32_t row_count(const scene::Scene& scene, language::ElementKind kind);
bool is_alive(const scene::Scene& scene, language::ElementKind kind, std::uint32_t row);
// The number that people see.
std::uint32_t number_of(const scene::Scene& scene, language::ElementKind kind, std::uint32_t row);

// Elements in order, rows by number and facets by body, found once for each state of the connectivity.
class ElementIndex {
 public:
  // All of a kind in the order of their numbers.
  std::shared_ptr<const std::vector<language::Element>> all(const scene::Scene& scene,
                                                            language::ElementKind kind);
  // Nothing if there is no such element.
  std::optional<std::uint32_t> row(const scene::Scene& scene, language::ElementKind kind,
                                   std::uint32_t number);
  // The facets of a body, oriented so that it lies behind them, in the order of their rows.
  const std::vector<language::Element>& facets_of_body(const scene::Scene& scene, std::uint32_t body_row);

 private:
  void refresh(const scene::Scene& scene);

  std::uint64_t revision_ = 0;
  std::array<std::shared_ptr<const std::vector<language::Element>>, 3> all_;
  std::array<std::vector<std::uint32_t>, 3> rows_;
  std::vector<std::vector<language::Element>> body_facets_;
  std::vector<language::Element> none_;
};

// The elements of a kind that an element is made of or that meet in it:
//   vertex: edges going out, facets
//   edge: vertices tail and head, facets around it in which it runs forward or else reversed, bodies
//   facet: vertices, edges, bodies (behind it, in front of it)
//   body: facets
// Throws text::Error without a place for other pairs.
std::vector<language::Element> parts_of(const scene::Scene& scene, ElementIndex& index,
                                        const language::Element& element, language::ElementKind kind);

}  // namespace lamella::session
