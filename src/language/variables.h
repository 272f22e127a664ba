// The variables of a scene: numbers and strings by name.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lamella::language {

using Value = std::variant<double, std::string>;

// Numbers in an array, row by row; the shape {3} is a vector.
struct Array {
  std::vector<int> shape;
  std::vector<double> values;
};

// The row of a variable. It belongs to the name for the whole session, so parsed text can keep it.
struct VariableId {
  std::uint32_t row = 0;
  friend constexpr auto operator<=>(const VariableId&, const VariableId&) = default;
};

// Names, shared by all copies of a scene: undo takes values back, never ids.
class VariableNames {
 public:
  // Upper and lower case are the same.
  VariableId id(std::string_view name);
  const std::string& name(VariableId id) const { return names_[id.row]; }
  std::size_t size() const { return names_.size(); }
  bool find(std::string_view name, VariableId& id) const;

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> rows_;
};

struct Variable {
  Value value = 0.0;
  Array array;  // with a shape if the variable is an array; the value says nothing then
  bool defined = false;
  bool parameter = false;  // declared by PARAMETER in the datafile's top section
  bool permanent = false;  // outlives the scene

  bool is_array() const { return !array.shape.empty(); }
};

class Variables {
 public:
  Variables() : names_(std::make_shared<VariableNames>()) {}

  // The id for a name, new or old; the variable stays undefined until `set`.
  VariableId id(std::string_view name) { return names_->id(name); }
  const std::string& name(VariableId id) const { return names_->name(id); }
  // Null where no such variable is defined.
  const Variable* find(std::string_view name) const;
  const Variable* get(VariableId id) const;
  std::optional<VariableId> find_id(std::string_view name) const;
  void set(VariableId id, Value value);
  // Makes the variable an array; what fits of an earlier one of as many dimensions stays.
  void set_shape(VariableId id, const std::vector<int>& shape);
  // The variable must be an array with this component, in row order.
  void set_component(VariableId id, std::size_t component, double value);
  void mark_permanent(VariableId id);
  void mark_parameter(VariableId id);
  void undefine(VariableId id);
  // Changes with every change of a value; equal for copies.
  std::uint64_t revision() const { return revision_; }
  // In order of first mention; undefined rows included.
  std::size_t rows() const { return values_.size(); }
  // Calls function(VariableId, const Variable&) for each defined variable, in that order.
  template <class Function>
  void for_each(Function&& function) const {
    for (std::uint32_t i = 0; i < values_.size(); ++i) {
      if (values_[i].defined) function(VariableId{i}, values_[i]);
    }
  }
  // Takes over the ids of another scene's names and its permanent values (a new scene in the same session).
  void restart_like(const Variables& other);

 private:
  Variable& row(VariableId id);

  std::shared_ptr<VariableNames> names_;
  std::vector<Variable> values_;
  std::uint64_t revision_ = 0;
};

}  // namespace lamella::language
