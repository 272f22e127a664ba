#include "scene/periods.h"

#include <algorithm>
#include <cmath>

#include "text/error.h"

namespace lamella::scene {

namespace {

constexpr double flat = 1e-12;  // a cell's volume over the product of its edges

}  // namespace

std::array<film::Vec3, 3> present_periods(Scene& scene) {
  std::array<film::Vec3, 3> periods{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::size_t dimension = scene.periods.size() == 4 ? 2 : 3;
  for (std::size_t i = 0; i < scene.periods.size(); ++i) {
    language::Formula& formula = scene.periods[i];
    formula.bind(scene.variables, present_gravity(scene));
    const double value = formula.value({});
    if (!std::isfinite(value))
      throw text::Error("a period is not a finite number: " + formula.text(),
                        "other values of the parameters that it names");
    periods[i / dimension][static_cast<int>(i % dimension)] = value;
  }
  const auto& [a, b, c] = periods;
  if (!(std::abs(dot(a, cross(b, c))) > flat * length(a) * length(b) * length(c)))
    throw text::Error("the periods lie in a plane", "three independent vectors are needed");
  return periods;
}

void renew_periods(Scene& scene) {
  if (scene.periods.empty()) return;
  const std::array<film::Vec3, 3> periods = present_periods(scene);
  if (scene.film.periodic() && scene.film.lattice()->periods() == periods) return;
  scene.film.set_lattice(film::Lattice(periods));
  // Whoever remembers what was at these positions must look again.
  scene.film.edit_positions();
}

bool periods_read(const Scene& scene, language::VariableId variable) {
  return std::any_of(scene.periods.begin(), scene.periods.end(), [&](const language::Formula& formula) {
    const auto names = formula.variables();
    return std::find(names.begin(), names.end(), variable) != names.end();
  });
}

}  // namespace lamella::scene
