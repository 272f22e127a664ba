#include "datafile/write_commands.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "datafile/write_constraints.h"
#include "language/letters.h"

namespace lamella::datafile {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    switch (c) {
      case '\n':
        result += "\\n";
        break;
      case '\r':
        result += "\\r";
        break;
      case '\t':
        result += "\\t";
        break;
      case '\b':
        result += "\\b";
        break;
      case '"':
      case '\\':
        result += '\\';
        [[fallthrough]];
      default:
        result += c;
    }
  }
  return result + '"';
}

// `procedure NAME(real a, real b)`, `function real NAME(...)`; empty where there are no parameters.
std::string heading(const language::Procedure& procedure) {
  if (procedure.parameters.empty() && !procedure.returns_value) return {};
  return fmt::format("{} {}({})", procedure.returns_value ? "function real" : "procedure", procedure.name,
                     fmt::join(procedure.parameters, ", "));
}

// Its declaration, and an assignment for each component that is not 0.
std::string written_array(const std::string& name, const language::Array& array) {
  std::string out = fmt::format("define {} real[{}]\n", name, fmt::join(array.shape, "]["));
  for (std::size_t i = 0; i < array.values.size(); ++i) {
    if (array.values[i] == 0 || !std::isfinite(array.values[i])) continue;
    std::vector<std::size_t> indices(array.shape.size());
    std::size_t rest = i;
    for (std::size_t d = indices.size(); d-- > 0;) {
      const auto size = static_cast<std::size_t>(array.shape[d]);
      indices[d] = rest % size + 1;
      rest /= size;
    }
    out += fmt::format("{}[{}] := {}\n", name, fmt::join(indices, "]["), array.values[i]);
  }
  return out;
}

void write_variables(std::string& out, const scene::Scene& scene) {
  const std::set<language::VariableId> read = variables_of_formulas(scene);
  scene.variables.for_each([&](language::VariableId id, const language::Variable& variable) {
    if (variable.parameter || read.contains(id)) return;
    if (variable.is_array()) {
      out += written_array(scene.variables.name(id), variable.array);
      return;
    }
    const std::string value = written_value(variable.value);
    const std::string& name = scene.variables.name(id);
    out += value.empty() ? fmt::format("// {} was not a finite number\n", name)
                         : fmt::format("{} := {}\n", name, value);
  });
}

// All are announced before the first is defined, as they may call each other.
void write_procedures(std::string& out, const scene::Scene& scene) {
  for (const auto& [key, procedure] : scene.procedures) {
    const std::string head = heading(procedure);
    if (!language::letter_of(key).empty()) continue;
    out += head.empty() ? fmt::format("{} := {{}}\n", procedure.name) : fmt::format("{};\n", head);
  }
  for (const auto& [key, procedure] : scene.procedures) {
    if (procedure.source.empty()) continue;
    if (const std::string_view letter = language::letter_of(key); !letter.empty()) {
      out += fmt::format("{} :::= {}\n", letter, procedure.source);
      continue;
    }
    const std::string head = heading(procedure);
    out +=
        fmt::format("{} {}\n", head.empty() ? fmt::format("{} :=", procedure.name) : head, procedure.source);
  }
}

}  // namespace

std::string written_value(const language::Value& value) {
  if (const std::string* const text = std::get_if<std::string>(&value)) return quoted(*text);
  const double number = std::get<double>(value);
  return std::isfinite(number) ? fmt::format("{}", number) : std::string{};
}

void write_commands(std::string& out, const scene::Scene& scene) {
  std::string commands;
  if (!scene.gravity.on) commands += "gravity off\n";
  if (!scene.view_transforms.expression.empty())
    commands += fmt::format("transform_expr {}\n", quoted(scene.view_transforms.expression));
  if (scene.view_transforms.on) commands += "transforms on\n";
  write_variables(commands, scene);
  write_procedures(commands, scene);
  if (!commands.empty()) out += "\nread\n\n" + commands;
}

}  // namespace lamella::datafile
