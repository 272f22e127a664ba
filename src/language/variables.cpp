#include "language/variables.h"

#include <atomic>
#include <utility>

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
  variable.array = {};
  variable.defined = true;
}

void Variables::set_shape(VariableId id, const std::vector<int>& shape) {
  Variable& variable = row(id);
  Array made{shape, {}};
  std::size_t count = 1;
  for (const int size : shape) count *= static_cast<std::size_t>(size);
  made.values.resize(count, 0);
  const Array old = std::exchange(variable.array, {});
  const bool fits = old.shape.size() == shape.size();
  for (std::size_t i = 0; fits && i < count; ++i) {
    // The indices of component i, and where the old array keeps them.
    std::size_t rest = i;
    std::size_t from = 0;
    std::size_t stride = 1;
    bool inside = true;
    for (std::size_t d = shape.size(); d-- > 0;) {
      const std::size_t index = rest % static_cast<std::size_t>(shape[d]);
      rest /= static_cast<std::size_t>(shape[d]);
      inside = inside && index < static_cast<std::size_t>(old.shape[d]);
      from += index * stride;
      stride *= static_cast<std::size_t>(old.shape[d]);
    }
    if (inside) made.values[i] = old.values[from];
  }
  variable.array = std::move(made);
  variable.value = 0.0;
  variable.defined = true;
}

void Variables::set_component(VariableId id, std::size_t component, double value) {
  row(id).array.values[component] = value;
}

void Variables::mark_permanent(VariableId id) {
  row(id).permanent = true;
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
  for (std::uint32_t i = 0; i < other.values_.size(); ++i) {
    if (other.values_[i].defined && other.values_[i].permanent) row({i}) = other.values_[i];
  }
}

}  // namespace lamella::language
