// The attributes of elements that expressions know: `x` of vertices, `length` of edges, `volume` of bodies
// and the rest, and what the user defines (`define edge attribute heat real`).
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "energy/measure.h"
#include "language/evaluate.h"
#include "language/scope.h"
#include "scene/scene.h"

namespace lamella::session {

// What attributes are read from and written to.
struct AttributeSource {
  scene::Scene& scene;
  energy::MeasureCache& measures;
};

// One row of the table. `column` names the film's column that keeps it, for those that are kept so; the
// functions are for the others.
struct AttributeRow {
  language::ElementKind kind = language::ElementKind::vertex;
  std::string name;
  std::string summary;
  std::string column;
  std::vector<int> shape;
  double (*get)(const AttributeSource&, const language::Element&, int component) = nullptr;
  void (*set)(const AttributeSource&, const language::Element&, int component, double value) = nullptr;
  void (*unset)(const AttributeSource&, const language::Element&, int component) = nullptr;
  // The component is the number of a constraint or boundary, less one: `on_constraint 1`.
  bool takes_number = false;
};

// The rows' numbers hold for the whole session, so that parsed text can keep them.
class Attributes {
 public:
  Attributes();

  std::optional<language::AttributeMeaning> find(const scene::Scene& scene, language::ElementKind kind,
                                                 std::string_view name);
  // Of a built-in attribute; empty for others.
  std::string summary(language::ElementKind kind, std::string_view name) const;
  void collect_names(const scene::Scene& scene, language::ElementKind kind,
                     std::vector<std::string>& into) const;
  const AttributeRow& row(language::AttributeId id) const { return rows_[id.row]; }
  // An attribute that text already parsed will define: it is found from now on.
  void promise(language::ElementKind kind, std::string_view name, std::vector<int> shape);
  void forget_promises() { promised_.clear(); }

  // All throw text::Error without a place: an attribute that is gone, a value it cannot have, one that only
  // the film itself determines.
  double get(const AttributeSource& source, language::AttributeId id, const language::Element& element,
             int component) const;
  void set(const AttributeSource& source, language::AttributeId id, const language::Element& element,
           int component, double value) const;
  void unset(const AttributeSource& source, language::AttributeId id, const language::Element& element,
             int component) const;
  bool can_set(language::AttributeId id) const;

 private:
  language::AttributeMeaning user_row(language::ElementKind kind, const std::string& name,
                                      const std::vector<int>& shape);

  std::vector<AttributeRow> promised_;
  std::deque<AttributeRow> rows_;  // the built-in ones first; references stay valid
};

film::ElementKind film_kind(language::ElementKind kind);
film::Columns& columns_of(scene::Scene& scene, language::ElementKind kind);
const film::Columns& columns_of(const scene::Scene& scene, language::ElementKind kind);

}  // namespace lamella::session
