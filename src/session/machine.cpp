#include "session/machine.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "language/letters.h"
#include "session/argument_parser.h"
#include "session/follow_formulas.h"
#include "session/internal_variables.h"
#include "session/interrupt.h"
#include "session/parameter_parts.h"
#include "session/quantity_parts.h"
#include "session/scene_functions.h"
#include "session/session.h"
#include "session/switches.h"
#include "text/suggest.h"

namespace lamella::session {

using language::Element;
using language::ElementKind;
using language::Value;

const Value& Machine::variable(language::VariableId id) {
  const language::Variables& variables = session_.scene().variables;
  const language::Variable* const variable = variables.get(id);
  if (variable == nullptr) throw text::Error(fmt::format("\"{}\" has no value", variables.name(id)));
  if (variable->is_array()) {
    throw text::Error(fmt::format("\"{}\" is an array", variables.name(id)),
                      fmt::format("name the component, as in {}[1]", variables.name(id)));
  }
  return variable->value;
}

const language::Array* Machine::array(language::VariableId id) {
  const language::Variable* const variable = session_.scene().variables.get(id);
  return variable != nullptr && variable->is_array() ? &variable->array : nullptr;
}

Value Machine::internal(language::InternalId id) {
  if (is_quantity_part(id)) return quantity_part(session_.scene(), id);
  if (is_parameter_part(id)) return parameter_part(session_.scene(), id);
  return internal_variable(id).get(session_);
}

double Machine::attribute(language::AttributeId id, const Element& element, int component) {
  return session_.attributes().get(session_.attribute_source(), id, element, component);
}

bool Machine::is_defined(std::string_view name) {
  const scene::Scene& scene = session_.scene();
  return scene.variables.find(name) != nullptr || scene.procedures.contains(text::lower(name)) ||
         find_internal_variable(name) || session_.names().is_command(name) || language::element_kind(name);
}

std::shared_ptr<const std::vector<Element>> Machine::elements(ElementKind kind) {
  return index_.all(session_.scene(), kind);
}

bool Machine::exists(const Element& element) {
  return is_alive(session_.scene(), element.kind, element.row);
}

std::optional<Element> Machine::numbered(ElementKind kind, double number) {
  constexpr double most = 4e9;
  const double whole = std::trunc(number);
  if (!(std::abs(whole) >= 1 && std::abs(whole) < most)) return std::nullopt;
  const auto row = index_.row(session_.scene(), kind, static_cast<std::uint32_t>(std::abs(whole)));
  if (!row) return std::nullopt;
  return Element{kind, *row, whole < 0};
}

std::vector<Element> Machine::parts(const Element& element, ElementKind kind) {
  return parts_of(session_.scene(), index_, element, kind);
}

Value Machine::call(const std::string& function, std::span<const Value> arguments) {
  if (const SceneFunction* const found = find_scene_function(function);
      found != nullptr && procedure(function) == nullptr)
    return found->run(session_, arguments);
  const language::Procedure* const found = procedure(function);
  if (found == nullptr || !found->returns_value)
    throw text::Error(fmt::format("there is no function \"{}\"", function));
  // The procedure may be redefined while it runs.
  const language::Procedure called = *found;
  return call_procedure(called, arguments, *this, evaluation_);
}

// A parameter of the datafile takes along what its formulas hold.
void Machine::assign(language::VariableId id, Value value) {
  scene::Scene& scene = session_.scene();
  const language::Variable* const known = scene.variables.get(id);
  const bool moves = known != nullptr && known->parameter && known->value != value;
  scene.variables.set(id, std::move(value));
  if (moves && is_on(session_, *find_switch("autorecalc"))) follow_formulas(scene);
}

void Machine::make_permanent(language::VariableId id) {
  session_.scene().variables.mark_permanent(id);
}

void Machine::set_shape(language::VariableId id, const std::vector<int>& shape) {
  session_.scene().variables.set_shape(id, shape);
}

void Machine::assign(language::VariableId id, std::size_t component, double value) {
  session_.scene().variables.set_component(id, component, value);
}

void Machine::assign(language::InternalId id, const Value& value) {
  if (is_quantity_part(id)) return set_quantity_part(session_.scene(), id, value);
  if (is_parameter_part(id)) return set_parameter_part(session_.scene(), id, value);
  const InternalVariable& variable = internal_variable(id);
  if (variable.set == nullptr)
    throw text::Error(fmt::format("\"{}\" cannot be set: it is {}", variable.name, variable.summary));
  const double* const number = std::get_if<double>(&value);
  if (number == nullptr) throw text::Error(fmt::format("\"{}\" is a number, not a string", variable.name));
  variable.set(session_, *number);
}

void Machine::assign(language::AttributeId id, const Element& element, int component, double value) {
  session_.attributes().set(session_.attribute_source(), id, element, component, value);
}

const language::Procedure* Machine::procedure(const std::string& name) {
  const language::Procedures& procedures = session_.scene().procedures;
  const auto at = procedures.find(name);
  return at == procedures.end() ? nullptr : &at->second;
}

void Machine::define(const language::Procedure& procedure) {
  const std::string key = text::lower(procedure.name);
  language::Procedures& procedures = session_.scene().procedures;
  const auto at = procedures.find(key);
  if (!procedure.body && !language::letter_of(key).empty()) {
    procedures.erase(key);
    return;
  }
  // A declaration does not take away what is defined.
  if (!procedure.body && at != procedures.end() && at->second.body) return;
  procedures[key] = procedure;
}

void Machine::run_command(const language::CommandCall& call, language::Evaluation& evaluation) {
  const auto& invocation = static_cast<const Invocation&>(call);
  const std::vector<Given> given = invocation.evaluate(evaluation);
  session_.begin_command();
  invocation.command->run(session_, given);
}

void Machine::begin_redirection(language::Redirection kind, const std::string& target) {
  session_.output().begin(kind, target);
}

void Machine::end_redirection() {
  session_.output().end();
}

void Machine::cancel_redirection() {
  session_.output().cancel();
}

void Machine::between_statements() {
  if (interrupt::requested()) throw Interrupted{};
}

std::uint64_t Machine::structure() {
  return session_.scene().film.connectivity_revision();
}

double Machine::number(const Element& element) {
  return number_of(session_.scene(), element.kind, element.row);
}

}  // namespace lamella::session
