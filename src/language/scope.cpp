#include "language/scope.h"

#include <algorithm>

#include "text/suggest.h"

namespace lamella::language {

LocalId Locals::declare(std::string_view name, std::optional<ElementKind> element) {
  const LocalId id{static_cast<std::uint32_t>(names_.size())};
  names_.push_back({text::lower(name), id, element});
  slots_ = std::max(slots_, id.slot + 1);
  return id;
}

const Local* Locals::find(std::string_view name) const {
  const std::string key = text::lower(name);
  const auto at =
      std::find_if(names_.rbegin(), names_.rend(), [&](const Local& local) { return local.name == key; });
  return at == names_.rend() ? nullptr : &*at;
}

const Local* Locals::element_in_turn() const {
  const auto at = std::find_if(names_.rbegin(), names_.rend(),
                               [](const Local& local) { return local.element.has_value(); });
  return at == names_.rend() ? nullptr : &*at;
}

std::optional<VariableId> ConstantScope::variable(std::string_view name) const {
  return variables_.find_id(name);
}

void ConstantScope::collect_names(std::vector<std::string>& into) const {
  variables_.for_each([&](VariableId id, const Variable&) { into.push_back(variables_.name(id)); });
}

}  // namespace lamella::language
