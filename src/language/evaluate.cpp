#include "language/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "language/format.h"
#include "language/functions.h"
#include "text/error.h"

namespace lamella::language {

namespace {

// Runs `function`; an error from it that has no place gets this one.
template <class Run>
auto placed(const text::Place& place, Run&& run) {
  try {
    return run();
  } catch (const text::Error& error) {
    throw error.placed_at(place);
  }
}

double number_of(const Value& value, const text::Place& place) {
  if (const double* const number = std::get_if<double>(&value)) return *number;
  throw text::Error(place, fmt::format("a number is needed here, and this is the string \"{}\"",
                                       std::get<std::string>(value)));
}

Value local_value(const LocalValue& local) {
  if (const double* const number = std::get_if<double>(&local)) return *number;
  if (const std::string* const text = std::get_if<std::string>(&local)) return *text;
  return 0.0;
}

// One function for each kind of node.
struct Evaluator {
  Evaluation& evaluation;
  const text::Place& place;

  Environment& environment() const { return evaluation.environment(); }
  double number(const ExpressionPointer& expression) const {
    return evaluate_number(*expression, evaluation);
  }

  Value operator()(const Number& node) const { return node.value; }
  Value operator()(const Text& node) const { return node.content; }
  Value operator()(const VariableUse& node) const {
    return placed(place, [&] { return environment().variable(node.id); });
  }
  Value operator()(const ArrayUse& node) const {
    const Array* const array = environment().array(node.id);
    if (array == nullptr) throw text::Error(place, "this is no array: it takes no index");
    const int component = evaluate_component(node.indices, array->shape, place, evaluation);
    return array->values[static_cast<std::size_t>(component)];
  }
  Value operator()(const ArrayLiteral&) const {
    throw text::Error(place, "an array is no number", "assign it to an array");
  }
  Value operator()(const LocalUse& node) const { return local_value(evaluation.local(node.id)); }
  Value operator()(const InternalUse& node) const {
    return placed(place, [&] { return environment().internal(node.id); });
  }
  Value operator()(const AttributeUse& node) const {
    const Element element = evaluate_element(node.element, evaluation);
    const int component = evaluate_component(node, evaluation);
    return placed(place, [&] { return environment().attribute(node.attribute, element, component); });
  }
  Value operator()(const Unary& node) const {
    const double value = number(node.operand);
    return node.operation == UnaryOperator::negate ? -value : value == 0 ? 1.0 : 0.0;
  }
  Value operator()(const Chain& node) const;
  Value operator()(const Comparison& node) const;
  Value operator()(const Conditional& node) const {
    return evaluate(number(node.condition) != 0 ? *node.yes : *node.no, evaluation);
  }
  Value operator()(const Call& node) const;
  Value operator()(const UserCall& node) const {
    std::vector<Value> arguments;
    for (const ExpressionPointer& argument : node.arguments)
      arguments.push_back(evaluate(*argument, evaluation));
    return placed(place, [&] { return environment().call(node.name, arguments); });
  }
  Value operator()(const Aggregate& node) const;
  Value operator()(const Format& node) const {
    const std::string format = evaluate_text(*node.format, evaluation);
    std::vector<Value> arguments;
    for (const ExpressionPointer& argument : node.arguments)
      arguments.push_back(evaluate(*argument, evaluation));
    return placed(node.format->place, [&] { return Value(format_values(format, arguments)); });
  }
  Value operator()(const IsDefined& node) const {
    return environment().is_defined(evaluate_text(*node.name, evaluation)) ? 1.0 : 0.0;
  }
  Value operator()(const SizeOf& node) const {
    if (const auto array = evaluate_array(*node.of, evaluation))
      return static_cast<double>(array->values.size());
    const Value value = evaluate(*node.of, evaluation);
    const std::string* const content = std::get_if<std::string>(&value);
    return content != nullptr ? static_cast<double>(content->size()) : 1.0;
  }
  Value operator()(const ValidElement& node) const {
    try {
      evaluate_element(node.element, evaluation);
      return 1.0;
    } catch (const text::Error&) {
      return 0.0;
    }
  }
};

Value Evaluator::operator()(const Chain& node) const {
  double value = number(node.first);
  for (const Chain::Link& link : node.links) {
    // What decides alone leaves the rest alone.
    if (link.operation == BinaryOperator::logical_and && value == 0) return 0.0;
    if (link.operation == BinaryOperator::logical_or && value != 0) return 1.0;
    const double right = number(link.operand);
    value = placed(link.place, [&] { return apply(link.operation, value, right); });
  }
  return value;
}

Value Evaluator::operator()(const Comparison& node) const {
  const Value left = evaluate(*node.left, evaluation);
  const Value right = evaluate(*node.right, evaluation);
  const bool equality =
      node.operation == BinaryOperator::equal || node.operation == BinaryOperator::not_equal;
  if (equality && std::holds_alternative<std::string>(left) && std::holds_alternative<std::string>(right)) {
    return (left == right) == (node.operation == BinaryOperator::equal) ? 1.0 : 0.0;
  }
  return apply(node.operation, number_of(left, node.left->place), number_of(right, node.right->place));
}

Value Evaluator::operator()(const Call& node) const {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < node.arguments.size(); ++i) values.at(i) = number(node.arguments[i]);
  return placed(place, [&] { return node.function->value(std::span(values).first(node.arguments.size())); });
}

Value Evaluator::operator()(const Aggregate& node) const {
  double sum = 0;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  double count = 0;
  for_each_element(node.generator, evaluation, [&](const Element&) {
    const double value = node.kind == AggregateKind::count ? 0 : number(node.value);
    sum += value;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    count += 1;
    return true;
  });
  switch (node.kind) {
    case AggregateKind::sum:
      return sum;
    case AggregateKind::minimum:
      return least;
    case AggregateKind::maximum:
      return greatest;
    case AggregateKind::average:
      return count > 0 ? sum / count : 0;
    case AggregateKind::count:
      return count;
  }
  return 0.0;
}

// Only variables, for constant expressions.
class Constants : public Environment {
 public:
  explicit Constants(const Variables& variables) : variables_(variables) {}

  const Value& variable(VariableId id) override {
    const Variable* const variable = variables_.get(id);
    if (variable == nullptr) throw text::Error(fmt::format("\"{}\" is not defined", variables_.name(id)));
    return variable->value;
  }
  const Array* array(VariableId) override { return nullptr; }
  Value internal(InternalId) override { refuse(); }
  double attribute(AttributeId, const Element&, int) override { refuse(); }
  bool is_defined(std::string_view name) override { return variables_.find(name) != nullptr; }
  std::shared_ptr<const std::vector<Element>> elements(ElementKind) override { refuse(); }
  bool exists(const Element&) override { refuse(); }
  std::optional<Element> numbered(ElementKind, double) override { refuse(); }
  std::vector<Element> parts(const Element&, ElementKind) override { refuse(); }
  Value call(const std::string&, std::span<const Value>) override { refuse(); }

 private:
  [[noreturn]] static void refuse() {
    throw text::Error("only numbers, parameters and functions may stand here");
  }

  const Variables& variables_;
};

}  // namespace

Evaluation::Frame::Frame(Evaluation& evaluation, std::uint32_t slots)
    : evaluation_(evaluation), outer_base_(evaluation.base_), outer_size_(evaluation.locals_.size()) {
  if (evaluation_.frames_ == 0) {
    evaluation_.stack_origin_ = reinterpret_cast<std::intptr_t>(__builtin_frame_address(0));
  }
  evaluation_.base_ = outer_size_;
  evaluation_.locals_.resize(outer_size_ + slots, 0.0);
  ++evaluation_.frames_;
}

Evaluation::Frame::~Frame() {
  evaluation_.base_ = outer_base_;
  evaluation_.locals_.resize(outer_size_);
  --evaluation_.frames_;
}

Value evaluate(const Expression& expression, Evaluation& evaluation) {
  return std::visit(Evaluator{evaluation, expression.place}, expression.node);
}

double evaluate_number(const Expression& expression, Evaluation& evaluation) {
  if (const Number* const number = std::get_if<Number>(&expression.node)) return number->value;
  return number_of(evaluate(expression, evaluation), expression.place);
}

std::string evaluate_text(const Expression& expression, Evaluation& evaluation) {
  Value value = evaluate(expression, evaluation);
  if (std::string* const text = std::get_if<std::string>(&value)) return std::move(*text);
  throw text::Error(expression.place, fmt::format("a string is needed here, and this is the number {:.15g}",
                                                  std::get<double>(value)));
}

bool is_true(const Expression& expression, Evaluation& evaluation) {
  return evaluate_number(expression, evaluation) != 0;
}

long evaluate_count(const Expression& expression, Evaluation& evaluation, std::string_view what) {
  const double value = evaluate_number(expression, evaluation);
  constexpr double largest = 1e15;
  if (value != std::floor(value) || std::abs(value) > largest) {
    throw text::Error(expression.place, fmt::format("{} must be a whole number, not {:.15g}", what, value));
  }
  return static_cast<long>(value);
}

Element evaluate_element(const ElementPath& path, Evaluation& evaluation) {
  Element element;
  if (path.local) {
    element = std::get<Element>(evaluation.local(*path.local));
  } else {
    const double number = evaluate_number(*path.number, evaluation);
    const std::optional<Element> found =
        placed(path.place, [&] { return evaluation.environment().numbered(path.root_kind, number); });
    if (!found)
      throw text::Error(path.place, fmt::format("there is no {} {:.15g}", name_of(path.root_kind), number));
    element = *found;
  }
  for (const ElementPath::Step& step : path.steps) {
    const double index = evaluate_number(*step.index, evaluation);
    const std::vector<Element> parts =
        placed(step.place, [&] { return evaluation.environment().parts(element, step.kind); });
    if (!(index >= 1 && index < static_cast<double>(parts.size()) + 1)) {
      throw text::Error(step.place, fmt::format("there is no {} number {:.15g} here: there are {}",
                                                name_of(step.kind), index, parts.size()));
    }
    element = parts[static_cast<std::size_t>(index) - 1];
  }
  return element;
}

ArrayPart evaluate_part(std::span<const ExpressionPointer> indices, const std::vector<int>& shape,
                        const text::Place& place, Evaluation& evaluation) {
  if (indices.size() > shape.size()) {
    throw text::Error(place, fmt::format("an array of {} dimension{} takes no {} indices", shape.size(),
                                         shape.size() == 1 ? "" : "s", indices.size()));
  }
  ArrayPart part;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const auto size = static_cast<std::size_t>(shape[i]);
    part.first *= size;
    if (i >= indices.size()) {
      part.shape.push_back(shape[i]);
      part.count *= size;
      continue;
    }
    const double index = std::floor(evaluate_number(*indices[i], evaluation));
    if (!(index >= 1 && index <= shape[i])) {
      throw text::Error(indices[i]->place,
                        fmt::format("index {:.15g} is not between 1 and {}", index, shape[i]));
    }
    part.first += static_cast<std::size_t>(index) - 1;
  }
  return part;
}

int evaluate_component(std::span<const ExpressionPointer> indices, const std::vector<int>& shape,
                       const text::Place& place, Evaluation& evaluation) {
  if (indices.size() < shape.size())
    throw text::Error(place, "this is an array: name the component, as in [1]");
  return static_cast<int>(evaluate_part(indices, shape, place, evaluation).first);
}

int evaluate_component(const AttributeUse& use, Evaluation& evaluation) {
  return evaluate_component(use.indices, use.shape, use.element.place, evaluation);
}

namespace {

std::optional<Array> variable_array(VariableId id, std::span<const ExpressionPointer> indices,
                                    const text::Place& place, Evaluation& evaluation) {
  const Array* const array = evaluation.environment().array(id);
  if (array == nullptr || indices.size() >= array->shape.size()) return std::nullopt;
  ArrayPart part = evaluate_part(indices, array->shape, place, evaluation);
  const auto begin = array->values.begin() + static_cast<std::ptrdiff_t>(part.first);
  return Array{std::move(part.shape), {begin, begin + static_cast<std::ptrdiff_t>(part.count)}};
}

Array literal_array(const ArrayLiteral& literal, Evaluation& evaluation) {
  Array result{{static_cast<int>(literal.items.size())}, {}};
  std::vector<int> row_shape;
  for (std::size_t i = 0; i < literal.items.size(); ++i) {
    const Expression& item = *literal.items[i];
    const std::optional<Array> row = evaluate_array(item, evaluation);
    const std::vector<int> shape = row ? row->shape : std::vector<int>{};
    if (i > 0 && shape != row_shape) throw text::Error(item.place, "the rows of this array differ in length");
    row_shape = shape;
    if (row) {
      result.values.insert(result.values.end(), row->values.begin(), row->values.end());
    } else {
      result.values.push_back(evaluate_number(item, evaluation));
    }
  }
  result.shape.insert(result.shape.end(), row_shape.begin(), row_shape.end());
  return result;
}

}  // namespace

std::optional<Array> evaluate_array(const Expression& expression, Evaluation& evaluation) {
  if (const VariableUse* const use = std::get_if<VariableUse>(&expression.node))
    return variable_array(use->id, {}, expression.place, evaluation);
  if (const ArrayLiteral* const literal = std::get_if<ArrayLiteral>(&expression.node))
    return literal_array(*literal, evaluation);
  if (const ArrayUse* const use = std::get_if<ArrayUse>(&expression.node))
    return variable_array(use->id, use->indices, expression.place, evaluation);
  const AttributeUse* const use = std::get_if<AttributeUse>(&expression.node);
  if (use == nullptr || use->indices.size() >= use->shape.size()) return std::nullopt;
  const Element element = evaluate_element(use->element, evaluation);
  ArrayPart part = evaluate_part(use->indices, use->shape, use->element.place, evaluation);
  Array result{std::move(part.shape), {}};
  for (std::size_t i = 0; i < part.count; ++i) {
    result.values.push_back(placed(expression.place, [&] {
      return evaluation.environment().attribute(use->attribute, element, static_cast<int>(part.first + i));
    }));
  }
  return result;
}

void for_each_element(const Generator& generator, Evaluation& evaluation,
                      const std::function<bool(const Element&)>& function) {
  const auto visit = [&](const Element& element) {
    if (!evaluation.environment().exists(element)) return true;
    evaluation.local(generator.slot) = element;
    if (generator.where && !is_true(*generator.where, evaluation)) return true;
    return function(element);
  };
  if (!generator.of) {
    const std::shared_ptr<const std::vector<Element>> all = evaluation.environment().elements(generator.kind);
    for (const Element& element : *all) {
      if (!visit(element)) return;
    }
    return;
  }
  const Element of = evaluate_element(*generator.of, evaluation);
  if (generator.single) {
    visit(of);
    return;
  }
  const std::vector<Element> parts =
      placed(generator.place, [&] { return evaluation.environment().parts(of, generator.kind); });
  for (const Element& part : parts) {
    if (!visit(part)) return;
  }
}

std::vector<Element> evaluate_elements(const Generator& generator, Evaluation& evaluation) {
  std::vector<Element> result;
  for_each_element(generator, evaluation, [&](const Element& element) {
    result.push_back(element);
    return true;
  });
  return result;
}

Value evaluate_constant_value(const Expression& expression, const Variables& variables) {
  Constants constants(variables);
  Evaluation evaluation(constants);
  return evaluate(expression, evaluation);
}

double evaluate_constant(const Expression& expression, const Variables& variables) {
  return number_of(evaluate_constant_value(expression, variables), expression.place);
}

}  // namespace lamella::language
