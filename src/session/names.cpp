#include "session/names.h"

#include <algorithm>

#include <fmt/format.h>

#include "language/evaluate.h"
#include "language/letters.h"
#include "session/argument_parser.h"
#include "session/internal_variables.h"
#include "session/parameter_parts.h"
#include "session/quantity_parts.h"
#include "session/refused_words.h"
#include "session/scene_functions.h"
#include "session/switches.h"
#include "text/suggest.h"

namespace lamella::session {

const Command* find_command(std::span<const Command* const> commands, std::string_view word) {
  const auto matches = [word](const std::string& name) {
    return name.size() == 1 ? name == word : name == text::lower(word);
  };
  for (const Command* const command : commands) {
    if (matches(command->name) || std::any_of(command->aliases.begin(), command->aliases.end(), matches))
      return command;
  }
  return find_switch_command(word);
}

std::optional<language::VariableId> Names::variable(std::string_view name) const {
  if (const auto id = scene_.variables.find_id(name)) return id;
  for (const std::uint32_t row : promised_variables_) {
    if (text::lower(scene_.variables.name({row})) == text::lower(name)) return language::VariableId{row};
  }
  return std::nullopt;
}

std::optional<language::InternalId> Names::internal(std::string_view name) const {
  if (const auto part = find_quantity_part(scene_, name)) return part;
  if (const auto part = find_parameter_part(scene_, name)) return part;
  return find_internal_variable(name);
}

std::optional<language::AttributeMeaning> Names::attribute(language::ElementKind kind,
                                                           std::string_view name) const {
  return attributes_.find(scene_, kind, name);
}

std::optional<int> Names::number_named(language::AttributeId attribute, std::string_view name) const {
  const std::string key = text::lower(name);
  const auto find = [&](const auto& declared) -> std::optional<int> {
    for (const auto& [number, one] : declared) {
      if (one.name == key) return number;
    }
    return std::nullopt;
  };
  const bool boundary = attributes_.row(attribute).name.find("boundary") != std::string::npos;
  return boundary ? find(scene_.boundaries) : find(scene_.level_sets);
}

std::optional<language::Arity> Names::user_function(std::string_view name) const {
  const auto exactly = [](std::size_t parameters) { return language::Arity{parameters, parameters}; };
  const std::string key = text::lower(name);
  if (const auto at = promised_procedures_.find(key); at != promised_procedures_.end()) {
    if (!at->second.returns_value) return std::nullopt;
    return exactly(at->second.parameters);
  }
  const auto at = scene_.procedures.find(key);
  if (at != scene_.procedures.end() && at->second.returns_value) return exactly(at->second.parameters.size());
  if (const SceneFunction* const found = find_scene_function(key)) return found->arity;
  return std::nullopt;
}

std::string Names::why_refused(std::string_view word) const {
  return std::string(refusal(word));
}

void Names::collect_names(std::vector<std::string>& into) const {
  scene_.variables.for_each(
      [&](language::VariableId id, const auto&) { into.push_back(scene_.variables.name(id)); });
  for (const InternalVariable& variable : internal_variables()) into.emplace_back(variable.name);
  for (const auto& [key, procedure] : scene_.procedures) {
    if (procedure.returns_value) into.push_back(procedure.name);
  }
  for (const SceneFunction& function : scene_functions()) into.emplace_back(function.name);
}

void Names::collect_parts(std::string_view name, std::vector<std::string>& into) const {
  for (const std::string_view part : quantity_part_names) {
    std::string whole = fmt::format("{}.{}", name, part);
    if (find_quantity_part(scene_, whole)) into.push_back(std::move(whole));
  }
  for (const std::string_view part : parameter_part_names) {
    std::string whole = fmt::format("{}.{}", name, part);
    if (find_parameter_part(scene_, whole)) into.push_back(std::move(whole));
  }
}

void Names::collect_attributes(language::ElementKind kind, std::vector<std::string>& into) const {
  attributes_.collect_names(scene_, kind, into);
}

std::optional<std::size_t> Names::procedure(std::string_view name) const {
  const std::string key = text::lower(name);
  if (const auto at = promised_procedures_.find(key); at != promised_procedures_.end())
    return at->second.parameters;
  const auto at = scene_.procedures.find(key);
  if (at == scene_.procedures.end()) return std::nullopt;
  return at->second.parameters.size();
}

language::VariableId Names::promise_variable(std::string_view name) {
  const language::VariableId id = scene_.variables.id(name);
  promised_variables_.insert(id.row);
  return id;
}

void Names::promise_procedure(std::string_view name, std::size_t parameters, bool returns_value) {
  promised_procedures_[text::lower(name)] = {parameters, returns_value};
}

void Names::promise_attribute(language::ElementKind kind, std::string_view name, std::vector<int> shape) {
  attributes_.promise(kind, name, std::move(shape));
}

std::optional<int> Names::present_size(const language::Expression& size) const {
  constexpr double most = 1e6;
  try {
    const double value = language::evaluate_constant(size, scene_.variables);
    if (value >= 1 && value <= most) return static_cast<int>(value);
  } catch (const text::Error&) {
    // It takes the run to tell.
  }
  return std::nullopt;
}

std::unique_ptr<const language::CommandCall> Names::parse_command(language::LexerStream& tokens) {
  const Command* const command = find_command(commands_, tokens.peek().text);
  brings_names_ = brings_names_ || command->brings_names;
  return parse_command_call(*command, tokens, *this);
}

void Names::collect_statement_words(std::vector<std::string>& into) const {
  for (const Command* const command : commands_) {
    into.push_back(command->name);
    into.insert(into.end(), command->aliases.begin(), command->aliases.end());
  }
  for (const auto& [key, procedure] : scene_.procedures) {
    if (language::letter_of(key).empty()) into.push_back(procedure.name);
  }
}

void Names::forget_promises() {
  promised_variables_.clear();
  promised_procedures_.clear();
  attributes_.forget_promises();
  brings_names_ = false;
}

}  // namespace lamella::session
