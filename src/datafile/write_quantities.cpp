#include "datafile/write_quantities.h"

#include <iterator>
#include <set>

#include <fmt/format.h>

#include "datafile/put.h"

namespace lamella::datafile {

namespace {

using scene::MethodInstance;
using scene::Quantity;
using scene::QuantityRole;

void write_details(std::string& out, const MethodInstance& instance) {
  if (instance.modulus != 1) put(out, " modulus {}", instance.modulus);
  if (!instance.element_modulus.empty()) put(out, " element_modulus {}", instance.element_modulus);
  if (instance.global) out += " global";
  out += '\n';
  if (instance.scalar) put(out, "scalar_integrand: {}\n", instance.scalar.text());
  if (!instance.field[0] && !instance.field[1] && !instance.field[2]) return;
  out += "vector_integrand:\n";
  for (std::size_t i = 0; i < 3; ++i)
    put(out, "q{}: {}\n", i + 1, instance.field[i] ? instance.field[i].text() : "0");
}

// Each once: it may serve several quantities.
void write_instances(std::string& out, const scene::Scene& scene) {
  std::set<std::string> written;
  for (const Quantity& quantity : scene.quantities) {
    for (const MethodInstance& instance : quantity.methods) {
      if (instance.name.empty() || !written.insert(instance.name).second) continue;
      put(out, "\nmethod_instance {} method {}", instance.name, scene::name_of(instance.method));
      MethodInstance plain = instance;
      plain.global = false;
      write_details(out, plain);
    }
  }
}

void write_role(std::string& out, const Quantity& quantity) {
  switch (quantity.role) {
    case QuantityRole::info_only:
      out += " info_only";
      break;
    case QuantityRole::energy:
      out += " energy";
      break;
    case QuantityRole::conserved:
      out += " conserved";
      break;
    case QuantityRole::fixed:
      put(out, " fixed = {}", quantity.target);
      if (quantity.pressure != 0) put(out, " lagrange_multiplier {}", quantity.pressure);
      break;
  }
  if (quantity.modulus != 1) put(out, " modulus {}", quantity.modulus);
}

}  // namespace

void write_quantities(std::string& out, const scene::Scene& scene) {
  write_instances(out, scene);
  for (const Quantity& quantity : scene.quantities) {
    put(out, "\nquantity {}", quantity.name);
    write_role(out, quantity);
    for (const MethodInstance& instance : quantity.methods) {
      if (instance.name.empty()) {
        put(out, " method {}", scene::name_of(instance.method));
        write_details(out, instance);
      } else {
        put(out, " {} {}\n", instance.global ? "global_method" : "method", instance.name);
      }
    }
  }
}

MembershipWriter::MembershipWriter(const scene::Scene& scene, film::ElementKind kind) {
  const film::Columns& columns = scene.film.columns(kind);
  const auto add = [&](const std::string& name) {
    const film::Column* const column = columns.find(scene::membership_column(name));
    if (column != nullptr) marks_.push_back({column, name});
  };
  std::set<std::string> seen;
  for (const Quantity& quantity : scene.quantities) {
    add(quantity.name);
    for (const MethodInstance& instance : quantity.methods) {
      if (!instance.name.empty() && seen.insert(instance.name).second) add(instance.name);
    }
  }
}

void MembershipWriter::write(std::string& out, std::uint32_t row) const {
  for (const Mark& mark : marks_) {
    if (mark.column->value(row) == 0) continue;
    out += ' ';
    out += mark.name;
  }
}

}  // namespace lamella::datafile
