// What names mean at a place in a text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language/expression.h"

namespace lamella::language {

// How many arguments a function takes.
struct Arity {
  std::size_t least = 0;
  std::size_t most = 0;
};

struct AttributeMeaning {
  AttributeId id;
  std::vector<int> shape;  // empty for a single number
  // Instead of an index in brackets a number follows, or the name of what has that number: `on_constraint 1`.
  bool takes_number = false;
};

// A name that only a block, a loop or a procedure knows.
struct Local {
  std::string name;  // lower case; empty for a loop's element without a name
  LocalId id;
  std::optional<ElementKind> element;  // the element in turn of a loop; else a number or string
};

// The local names in force, innermost last. Slots of a block that has ended are used again.
class Locals {
 public:
  LocalId declare(std::string_view name, std::optional<ElementKind> element = {});
  const Local* find(std::string_view name) const;
  // The element whose attributes may be named alone: that of the innermost loop. Null outside loops.
  const Local* element_in_turn() const;
  const std::vector<Local>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }
  void forget_after(std::size_t size) { names_.resize(size); }
  // The slots that a run of the text needs.
  std::uint32_t slots() const { return slots_; }

 private:
  std::vector<Local> names_;
  std::uint32_t slots_ = 0;
};

class Scope {
 public:
  virtual ~Scope() = default;

  // A variable that is defined, or that text already parsed will define.
  virtual std::optional<VariableId> variable(std::string_view name) const = 0;
  virtual std::optional<InternalId> internal(std::string_view /*name*/) const { return {}; }
  virtual std::optional<AttributeMeaning> attribute(ElementKind, std::string_view /*name*/) const {
    return {};
  }
  // The number of what has a name, where an attribute takes a number.
  virtual std::optional<int> number_named(AttributeId, std::string_view /*name*/) const { return {}; }
  // A function that the user defined, or one that acts on the scene (`new_vertex`). One without arguments may
  // stand without parentheses.
  virtual std::optional<Arity> user_function(std::string_view /*name*/) const { return {}; }
  // Whether there are elements to speak of (in a datafile's top there are none yet).
  virtual bool has_elements() const { return false; }

  // Candidates for suggestions and for Tab.
  virtual void collect_names(std::vector<std::string>& /*into*/) const {}
  virtual void collect_attributes(ElementKind, std::vector<std::string>& /*into*/) const {}
  // "height.fixed" and the like: names with a dot whose first half is this one.
  virtual void collect_parts(std::string_view /*name*/, std::vector<std::string>& /*into*/) const {}

  Locals& locals() { return locals_; }
  const Locals& locals() const { return locals_; }

 private:
  Locals locals_;
};

// Forgets the local names declared during its life.
class LocalNames {
 public:
  explicit LocalNames(Scope& scope) : scope_(scope), size_(scope.locals().size()) {}
  LocalNames(const LocalNames&) = delete;
  LocalNames& operator=(const LocalNames&) = delete;
  ~LocalNames() { scope_.locals().forget_after(size_); }

 private:
  Scope& scope_;
  std::size_t size_;
};

// The scope of constant expressions: variables that have a value, numbers by name, functions.
class ConstantScope : public Scope {
 public:
  explicit ConstantScope(const Variables& variables) : variables_(variables) {}
  std::optional<VariableId> variable(std::string_view name) const override;
  void collect_names(std::vector<std::string>& into) const override;

 private:
  const Variables& variables_;
};

}  // namespace lamella::language
