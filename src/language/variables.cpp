#include "language/variables.h"

#include <atomic>

#include "text/suggest.h"

namespace lamella::language {

VariableId VariableNames::id(std::string_view name) {
  const std::string key = text::lower(name);
  const auto [at, added] = rows_.try_emplace(key, static_cast<std::uint32_t>(names_.size()));
  if (added) names_.emplace_back(name);
  return {at->second};
}

bool VariableNames::find(std::string_view name, VariableId& id) const {
  const auto at = rows_.find(text::lower(name));
  if (at == rows_.end()) return false;
  id = {at->second};
  return true;
}

const Variable* Variables::find(std::string_view name) const {
  VariableId id;
  return names_->find(name, id) ? get(id) : nullptr;
}

std::optional<VariableId> Variables::find_id(std::string_view name) const {
  VariableId id;
  if (names_->find(name, id) && get(id) != nullptr) return id;
  return std::nullopt;
}

const Variable* Variables::get(VariableId id) const {
  return id.row < values_.size() && values_[id.row].defined ? &values_[id.row] : nullptr;
}

Variable& Variables::row(VariableId id) {
  static std::atomic<std::uint64_t> last_revision{0};
  revision_ = ++last_revision;
  if (id.row >= values_.size()) values_.resize(id.row + 1);
  return values_[id.row];
}

void Variables::set(VariableId id, Value value) {
  Variable& variable = row(id);
  variable.value = std::move(value);
  variable.defined = true;
}

void Variables::mark_parameter(VariableId id) {
  row(id).parameter = true;
}

void Variables::undefine(VariableId id) {
  row(id) = {};
}

void Variables::restart_like(const Variables& other) {
  names_ = other.names_;
  values_.clear();
}

}  // namespace lamella::language
