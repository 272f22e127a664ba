// Values of expressions.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "language/expression.h"
#include "language/variables.h"

namespace lamella::language {

// A local value, or the element in turn of a loop.
using LocalValue = std::variant<double, std::string, Element>;

// Where values come from while expressions are evaluated. Whatever is not there is thrown as text::Error
// without a place.
class Environment {
 public:
  virtual ~Environment() = default;

  virtual const Value& variable(VariableId id) = 0;
  // Null if the variable is no array.
  virtual const Array* array(VariableId id) = 0;
  virtual Value internal(InternalId id) = 0;
  // Of an attribute with a shape: the component in row order.
  virtual double attribute(AttributeId id, const Element& element, int component) = 0;
  virtual bool is_defined(std::string_view name) = 0;

  // All elements of a kind, in the order of their numbers.
  virtual std::shared_ptr<const std::vector<Element>> elements(ElementKind kind) = 0;
  // Whether an element listed before is still there.
  virtual bool exists(const Element& element) = 0;
  // The element of a number that people see (negative: reversed); nothing if there is none.
  virtual std::optional<Element> numbered(ElementKind kind, double number) = 0;
  // The parts of an element, such as the edges of a facet, oriented and in order around it.
  virtual std::vector<Element> parts(const Element& element, ElementKind kind) = 0;

  virtual Value call(const std::string& function, std::span<const Value> arguments) = 0;
};

// An environment and the local values of what runs in it.
class Evaluation {
 public:
  explicit Evaluation(Environment& environment) : environment_(environment) {}

  Environment& environment() { return environment_; }
  LocalValue& local(LocalId id) { return locals_[base_ + id.slot]; }
  std::size_t frames() const { return frames_; }
  // An address on the stack near which the outermost run began.
  std::intptr_t stack_origin() const { return stack_origin_; }

  // The locals of a running procedure, for the life of this object.
  class Frame {
   public:
    Frame(Evaluation& evaluation, std::uint32_t slots);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    ~Frame();

   private:
    Evaluation& evaluation_;
    std::size_t outer_base_;
    std::size_t outer_size_;
  };

 private:
  Environment& environment_;
  std::vector<LocalValue> locals_;
  std::size_t base_ = 0;
  std::size_t frames_ = 0;
  std::intptr_t stack_origin_ = 0;
};

// All throw text::Error with the place of the part that has no value.
Value evaluate(const Expression& expression, Evaluation& evaluation);
double evaluate_number(const Expression& expression, Evaluation& evaluation);
std::string evaluate_text(const Expression& expression, Evaluation& evaluation);
bool is_true(const Expression& expression, Evaluation& evaluation);
// A whole number; anything else is refused. `what` names it in the message.
long evaluate_count(const Expression& expression, Evaluation& evaluation, std::string_view what);
// A variable or attribute that is an array, named with fewer indices than it has dimensions: all its numbers.
// Nothing for other expressions.
std::optional<Array> evaluate_array(const Expression& expression, Evaluation& evaluation);

Element evaluate_element(const ElementPath& path, Evaluation& evaluation);
// Which component of an array the indices name, in row order.
int evaluate_component(std::span<const ExpressionPointer> indices, const std::vector<int>& shape,
                       const text::Place& place, Evaluation& evaluation);
// The first component that so many indices name, or fewer than there are dimensions, and how many there are.
struct ArrayPart {
  std::size_t first = 0;
  std::size_t count = 1;
  std::vector<int> shape;  // of the part; empty for a single component
};
ArrayPart evaluate_part(std::span<const ExpressionPointer> indices, const std::vector<int>& shape,
                        const text::Place& place, Evaluation& evaluation);
int evaluate_component(const AttributeUse& use, Evaluation& evaluation);

// The elements that a generator yields, collected before anything is done with them.
std::vector<Element> evaluate_elements(const Generator& generator, Evaluation& evaluation);
// Calls function(element) for each, with the element in the generator's slot; stops where it returns false.
void for_each_element(const Generator& generator, Evaluation& evaluation,
                      const std::function<bool(const Element&)>& function);

// An expression of numbers, names with values and functions alone.
double evaluate_constant(const Expression& expression, const Variables& variables);
Value evaluate_constant_value(const Expression& expression, const Variables& variables);

}  // namespace lamella::language
