#include "session/history.h"

#include <algorithm>

#include <fmt/format.h>

namespace lamella::session {

namespace {

// Columns that nobody has changed are the same object in both.
bool columns_differ(const film::Columns& a, const film::Columns& b) {
  const auto objects = [](const film::Columns& columns) {
    std::vector<const film::Column*> result;
    columns.for_each([&](const film::Column& column) { result.push_back(&column); });
    return result;
  };
  return a.rows() != b.rows() || objects(a) != objects(b);
}

bool same(const std::optional<scene::VolumeRamp>& a, const std::optional<scene::VolumeRamp>& b) {
  if (!a || !b) return !a && !b;
  return a->from == b->from && a->to == b->to && a->begin == b->begin && a->end == b->end;
}

bool same(const scene::Body& a, const scene::Body& b) {
  return a.original == b.original && a.target_volume == b.target_volume && same(a.ramp, b.ramp) &&
         a.fixed_pressure == b.fixed_pressure && a.pressure == b.pressure && a.density == b.density &&
         a.volume_offset == b.volume_offset && a.absent == b.absent;
}

bool films_differ(const film::Film& a, const film::Film& b) {
  if (a.connectivity_revision() != b.connectivity_revision() ||
      a.position_revision() != b.position_revision())
    return true;
  return columns_differ(a.columns(film::ElementKind::vertex), b.columns(film::ElementKind::vertex)) ||
         columns_differ(a.columns(film::ElementKind::edge), b.columns(film::ElementKind::edge)) ||
         columns_differ(a.columns(film::ElementKind::facet), b.columns(film::ElementKind::facet));
}

bool bodies_differ(const scene::Scene& a, const scene::Scene& b) {
  return !std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                     [](const scene::Body& x, const scene::Body& y) { return same(x, y); });
}

bool variables_differ(const language::Variables& a, const language::Variables& b) {
  const std::size_t rows = std::max(a.rows(), b.rows());
  for (std::uint32_t row = 0; row < rows; ++row) {
    const language::Variable* const x = a.get({row});
    const language::Variable* const y = b.get({row});
    if ((x == nullptr) != (y == nullptr)) return true;
    if (x == nullptr) continue;
    if (x->value != y->value || x->parameter != y->parameter || x->array.shape != y->array.shape ||
        x->array.values != y->array.values)
      return true;
  }
  return false;
}

bool procedures_differ(const language::Procedures& a, const language::Procedures& b) {
  return !std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && x.second.body == y.second.body;
  });
}

std::string text_of(const std::optional<scene::VectorFormula>& formula) {
  return formula ? formula->text() : std::string{};
}

bool air_differs(const std::optional<scene::Air>& a, const std::optional<scene::Air>& b) {
  if (!a || !b) return a.has_value() != b.has_value();
  return a->cells != b->cells || a->from != b->from || a->to != b->to || text_of(a->fan) != text_of(b->fan) ||
         text_of(a->jet) != text_of(b->jet) || a->viscosity != b->viscosity || a->pressure != b->pressure ||
         a->velocity != b->velocity || a->time != b->time;
}

bool forces_differ(const scene::Forces& a, const scene::Forces& b) {
  return text_of(a.force) != text_of(b.force) || text_of(a.wind) != text_of(b.wind) ||
         a.wind_pressure != b.wind_pressure || air_differs(a.air, b.air);
}

bool quantities_differ(const scene::Scene& a, const scene::Scene& b) {
  return !std::equal(a.quantities.begin(), a.quantities.end(), b.quantities.begin(), b.quantities.end(),
                     [](const scene::Quantity& x, const scene::Quantity& y) {
                       return x.name == y.name && x.modulus == y.modulus && x.target == y.target;
                     });
}

bool settings_differ(const scene::Scene& a, const scene::Scene& b) {
  return a.gravity.constant != b.gravity.constant || a.gravity.on != b.gravity.on ||
         a.scale.value != b.scale.value || a.scale.fixed != b.scale.fixed || a.scale.limit != b.scale.limit ||
         a.keep_volumes != b.keep_volumes || a.symmetric_content != b.symmetric_content || a.time != b.time ||
         a.level_sets.size() != b.level_sets.size() || a.boundaries.size() != b.boundaries.size() ||
         a.gap_constant != b.gap_constant || a.edge_integral_order != b.edge_integral_order ||
         a.damping != b.damping || a.mass_of_area != b.mass_of_area || a.work != b.work ||
         a.mesh_fitness != b.mesh_fitness || forces_differ(a.forces, b.forces) || a.name != b.name ||
         quantities_differ(a, b) || a.view_transforms.expression != b.view_transforms.expression ||
         a.view_transforms.on != b.view_transforms.on;
}

}  // namespace

bool differs(const scene::Scene& a, const scene::Scene& b) {
  return films_differ(a.film, b.film) || bodies_differ(a, b) ||
         columns_differ(a.body_columns, b.body_columns) || variables_differ(a.variables, b.variables) ||
         procedures_differ(a.procedures, b.procedures) || settings_differ(a, b);
}

void History::push(scene::Scene before, std::string statement) {
  future_.clear();
  past_.push_back({std::move(before), std::move(statement)});
  drop_oldest();
}

// Counts what a step does not share with the next one, roughly: its positions always, all of it where the
// connectivity differs.
void History::drop_oldest() {
  std::size_t bytes = 0;
  for (std::size_t i = past_.size(); i-- > 0;) {
    const bool shares = i + 1 < past_.size() && past_[i].scene.film.connectivity_revision() ==
                                                    past_[i + 1].scene.film.connectivity_revision();
    bytes += shares ? past_[i].scene.film.vertex_rows() * sizeof(film::Vec3)
                    : past_[i].scene.film.bytes_with_columns();
    if (bytes > most_bytes_ && i + 1 < past_.size()) {
      past_.erase(past_.begin(), past_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return;
    }
  }
}

std::optional<std::string> History::undo(scene::Scene& scene) {
  if (past_.empty()) return std::nullopt;
  Step step = std::move(past_.back());
  past_.pop_back();
  future_.push_back({std::move(scene), step.statement});
  scene = std::move(step.scene);
  return std::move(step.statement);
}

std::optional<std::string> History::redo(scene::Scene& scene) {
  if (future_.empty()) return std::nullopt;
  Step step = std::move(future_.back());
  future_.pop_back();
  past_.push_back({std::move(scene), step.statement});
  scene = std::move(step.scene);
  return std::move(step.statement);
}

}  // namespace lamella::session
