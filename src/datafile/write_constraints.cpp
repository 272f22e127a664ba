#include "datafile/write_constraints.h"

#include <cstdlib>
#include <iterator>

#include <fmt/format.h>

namespace lamella::datafile {

namespace {

using language::Formula;

template <class Declared>
std::string name_of(const Declared& declared, int number) {
  const auto at = declared.find(number);
  return at != declared.end() && !at->second.name.empty() ? at->second.name : fmt::format("{}", number);
}

void write_components(std::string& out, std::string_view letter, const std::array<Formula, 3>& components) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string text = components[i] ? components[i].text() : "0";
    fmt::format_to(std::back_inserter(out), "{}{}: {}\n", letter, i + 1, text);
  }
}

template <class Set>
void write_integrals(std::string& out, const Set& set) {
  if (set.energy) {
    out += "energy:\n";
    write_components(out, "e", *set.energy);
  }
  if (set.content) {
    out += "content:\n";
    write_components(out, "c", *set.content);
  }
}

template <class Function>
void for_each_formula(const scene::Scene& scene, Function&& function) {
  const auto each = [&](const std::array<Formula, 3>& components) {
    for (const Formula& formula : components) function(formula);
  };
  const auto integrals = [&](const auto& set) {
    if (set.energy) each(*set.energy);
    if (set.content) each(*set.content);
  };
  for (const auto& [number, set] : scene.level_sets) {
    function(set.formula);
    integrals(set);
  }
  for (const auto& [number, boundary] : scene.boundaries) {
    each(boundary.position);
    integrals(boundary);
  }
  const auto vector = [&](const std::optional<scene::VectorFormula>& formula) {
    if (formula) each(formula->component);
  };
  vector(scene.forces.force);
  vector(scene.forces.wind);
  if (scene.forces.air) {
    vector(scene.forces.air->fan);
    vector(scene.forces.air->jet);
  }
  for (const Formula& formula : scene.periods) function(formula);
  for (const scene::Quantity& quantity : scene.quantities) {
    for (const scene::MethodInstance& instance : quantity.methods) {
      function(instance.scalar);
      each(instance.field);
    }
  }
}

}  // namespace

void write_constraints(std::string& out, const scene::Scene& scene) {
  for (const auto& [number, set] : scene.level_sets) {
    fmt::format_to(std::back_inserter(out), "\nconstraint {}", name_of(scene.level_sets, number));
    if (set.global) out += " global";
    if (set.convex) out += " convex";
    if (set.sense == scene::Sense::nonnegative) out += " nonnegative";
    if (set.sense == scene::Sense::nonpositive) out += " nonpositive";
    if (set.nonwall) out += " nonwall";
    fmt::format_to(std::back_inserter(out), "\nformula: {}\n", set.formula.text());
    write_integrals(out, set);
  }
  for (const auto& [number, boundary] : scene.boundaries) {
    fmt::format_to(std::back_inserter(out), "\nboundary {} parameters {}{}\n",
                   name_of(scene.boundaries, number), boundary.parameters, boundary.convex ? " convex" : "");
    write_components(out, "x", boundary.position);
    write_integrals(out, boundary);
  }
}

std::set<language::VariableId> variables_of_formulas(const scene::Scene& scene) {
  std::set<language::VariableId> result;
  for_each_formula(scene, [&](const Formula& formula) {
    result.insert(formula.variables().begin(), formula.variables().end());
  });
  return result;
}

ConstraintWriter::ConstraintWriter(const scene::Scene& scene, film::ElementKind kind)
    : scene_(scene),
      constraints_(scene.film.columns(kind).find(scene::constraint_column)),
      boundaries_(scene.film.columns(kind).find(scene::boundary_column)),
      orientation_(kind == film::ElementKind::vertex ||
                   scene.film.columns(kind).find("orientation") != nullptr) {}

// An edge that one integral runs backwards along is turned for all of them.
void ConstraintWriter::write_constraints(std::string& out, std::uint32_t row) const {
  bool turned = false;
  bool any = false;
  for (int k = 0; k < constraints_->width; ++k) {
    const int number = static_cast<int>(constraints_->value(row, k));
    if (number == 0) continue;
    if (!any) out += " constraints";
    any = true;
    turned = turned || number < 0;
    out += ' ';
    out += name_of(scene_.level_sets, std::abs(number));
  }
  if (turned && !orientation_) out += " orientation -1";
}

void ConstraintWriter::write(std::string& out, std::uint32_t row) const {
  if (constraints_ != nullptr) write_constraints(out, row);
  if (boundaries_ == nullptr || boundaries_->value(row) == 0) return;
  out += " boundary ";
  out += name_of(scene_.boundaries, static_cast<int>(boundaries_->value(row)));
}

}  // namespace lamella::datafile
