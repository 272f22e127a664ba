#include "evolution/external_forces.h"

#include <algorithm>
#include <cmath>

#include "film/normals.h"

namespace lamella::evolution {

namespace {

void bind(std::optional<scene::VectorFormula>& formula, const language::Variables& variables) {
  if (!formula) return;
  for (language::Formula& component : formula->component) component.bind(variables);
}

Vec3 value(const scene::VectorFormula& formula, const language::FormulaInputs& inputs) {
  return {formula.component[0].value(inputs), formula.component[1].value(inputs),
          formula.component[2].value(inputs)};
}

bool mentions_normal(const std::optional<scene::VectorFormula>& formula) {
  return formula && formula->text().find('n') != std::string::npos;
}

}  // namespace

ExternalForces::ExternalForces(const scene::Scene& scene) : film_(scene.film), forces_(scene.forces) {
  bind(forces_.force, scene.variables);
  bind(forces_.wind, scene.variables);
  if (forces_.air) air_.emplace(*forces_.air, scene.variables);
  needs_normals_ = forces_.wind.has_value() || air_ || mentions_normal(forces_.force);
}

// What wind and air do to a vertex: windward ones of bubbles are pushed, and all of films that part nothing.
Vec3 ExternalForces::blow(const Vec3& at, const language::FormulaInputs& inputs, const Vec3& velocity,
                          const Vec3& normal, bool closed) const {
  const auto push = [&](const Vec3& wind, double pressure) {
    const double through = dot(wind - velocity, normal);
    const bool sheltered = closed && through > 0;
    return sheltered ? Vec3{} : (pressure * through) * normal;
  };
  Vec3 sum;
  if (forces_.wind) sum += push(value(*forces_.wind, inputs), forces_.wind_pressure);
  if (air_) sum += push(air_->at(at), air_->pressure());
  return sum;
}

bool ExternalForces::evaluate(std::span<const Vec3> x, std::span<const Vec3> v,
                              std::span<const energy::VertexLine> lines, double time,
                              std::span<Vec3> accelerations) {
  const auto is_closed = [](const energy::VertexLine& line) {
    return squared_length(line.area_vector) > 1e-12 * line.area * line.area;
  };
  // Where regions differ the sweep's vector has a meaning of its own: out of the bubble.
  const bool all_closed =
      std::all_of(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(x.size()), is_closed);
  if (needs_normals_ && !all_closed) area_vectors_ = film::area_vectors(film_, x);
  bool finite = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool closed = is_closed(lines[i]);
    Vec3 normal;
    if (needs_normals_) {
      const Vec3 along = closed ? lines[i].area_vector : area_vectors_[i];
      const double size = length(along);
      if (size > 0) normal = along / size;
    }
    const std::array<double, 3> at = {x[i].x, x[i].y, x[i].z};
    const std::array<double, 6> state = {v[i].x, v[i].y, v[i].z, normal.x, normal.y, normal.z};
    const language::FormulaInputs inputs{at, time, state};
    Vec3 sum;
    if (forces_.force) sum += value(*forces_.force, inputs);
    if (forces_.wind || air_) sum += blow(x[i], inputs, v[i], normal, closed);
    accelerations[i] = sum;
    finite = finite && std::isfinite(sum.x + sum.y + sum.z);
  }
  return finite;
}

}  // namespace lamella::evolution
