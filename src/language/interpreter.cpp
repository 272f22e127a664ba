#include "language/interpreter.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "language/functions.h"
#include "text/error.h"

namespace lamella::language {

namespace {

// Deep enough for any sensible recursion; the stack holds it also where each call sits deep in an expression.
constexpr std::size_t deepest_calls = 1000;
constexpr std::ptrdiff_t most_stack = 4 << 20;

enum class Way : std::uint8_t { on, break_loop, continue_loop, return_value };

// Where the run goes after a statement.
struct Flow {
  Way way = Way::on;
  int levels = 0;  // loops still to leave
};

class Runner {
 public:
  Runner(Host& host, Evaluation& evaluation) : host_(host), evaluation_(evaluation) {}

  Flow run(const Block& block) {
    for (const StatementPointer& statement : block.statements) {
      const Flow flow = run(*statement);
      if (flow.way != Way::on) return flow;
    }
    return {};
  }

  Flow run(const Statement& statement) {
    host_.between_statements();
    try {
      return std::visit([&](const auto& node) { return run(node); }, statement.node);
    } catch (const text::Error& error) {
      throw error.placed_at(statement.place);
    }
  }

  Value returned = 0.0;

 private:
  Flow run(const CommandStatement& node) {
    host_.run_command(*node.call, evaluation_);
    return {};
  }
  Flow run(const RefusedCommand& node) { throw text::Error(node.message); }
  Flow run(const ExpressionStatement& node) {
    evaluate(*node.value, evaluation_);
    return {};
  }
  Flow run(const Assignment& node);
  void assign_array(const Assignment& node, VariableId id, std::span<const ExpressionPointer> indices,
                    const Array& array);
  Flow run(const ProcedureDefinition& node) {
    host_.define(node.procedure);
    return {};
  }
  Flow run(const ProcedureCall& node);
  Flow run(const Repetition& node);
  Flow run(const Conditionally& node) {
    if (is_true(*node.condition, evaluation_)) return run(*node.yes);
    return node.no ? run(*node.no) : Flow{};
  }
  Flow run(const Loop& node);
  Flow run(const Foreach& node);
  Flow run(const Break& node) { return {Way::break_loop, node.levels}; }
  Flow run(const Continue& node) { return {Way::continue_loop, node.levels}; }
  Flow run(const Return& node) {
    returned = node.value ? evaluate(*node.value, evaluation_) : Value(0.0);
    return {Way::return_value, 0};
  }
  Flow run(const LocalDeclaration& node) {
    for (const LocalId id : node.ids) evaluation_.local(id) = 0.0;
    return {};
  }
  Flow run(const Redirected& node);

  // After the body of a loop: whether the loop goes on, and if not, where the run goes.
  static bool goes_on(Flow& flow) {
    if (flow.way == Way::on) return true;
    if (flow.way == Way::return_value) return false;
    if (--flow.levels > 0) return false;
    const bool again = flow.way == Way::continue_loop;
    flow = {};
    return again;
  }

  Value present(const Assignment& node, const Element& element, int component);
  Value new_value(const Assignment& node, const Element& element, int component);

  Host& host_;
  Evaluation& evaluation_;
};

Value Runner::present(const Assignment& node, const Element& element, int component) {
  if (const auto* id = std::get_if<VariableId>(&node.target)) return host_.variable(*id);
  if (const auto* id = std::get_if<InternalId>(&node.target)) return host_.internal(*id);
  if (const auto* use = std::get_if<AttributeUse>(&node.target))
    return host_.attribute(use->attribute, element, component);
  if (const auto* use = std::get_if<ArrayUse>(&node.target))
    return host_.array(use->id)->values[static_cast<std::size_t>(component)];
  const LocalValue& local = evaluation_.local(std::get<LocalId>(node.target));
  if (const auto* text = std::get_if<std::string>(&local)) return *text;
  return std::get<double>(local);
}

Value Runner::new_value(const Assignment& node, const Element& element, int component) {
  if (node.kind == AssignmentKind::set) return evaluate(*node.value, evaluation_);
  const Value before = present(node, element, component);
  const double* const old = std::get_if<double>(&before);
  if (old == nullptr) throw text::Error("a string cannot be counted with", "use := and sprintf");
  const double by = evaluate_number(*node.value, evaluation_);
  switch (node.kind) {
    case AssignmentKind::add:
      return *old + by;
    case AssignmentKind::subtract:
      return *old - by;
    case AssignmentKind::multiply:
      return *old * by;
    default:
      return apply(BinaryOperator::divide, *old, by);
  }
}

// Into the part of the array that the indices name: every component, from an array of the same shape or from
// one number.
void Runner::assign_array(const Assignment& node, VariableId id, std::span<const ExpressionPointer> indices,
                          const Array& array) {
  const ArrayPart part = evaluate_part(indices, array.shape, node.value->place, evaluation_);
  const std::optional<Array> values = evaluate_array(*node.value, evaluation_);
  // Of a list of numbers, there may be fewer or more than there is room for.
  const bool list = std::holds_alternative<ArrayLiteral>(node.value->node) && values->shape.size() == 1 &&
                    part.shape.size() == 1;
  if (values && values->shape != part.shape && !list)
    throw text::Error(node.value->place, "this array has other dimensions than the one it goes to");
  if (values && node.kind != AssignmentKind::set)
    throw text::Error(node.value->place, "arrays are counted with number by number");
  const std::size_t count = values ? std::min(part.count, values->values.size()) : part.count;
  for (std::size_t i = 0; i < count; ++i) {
    const int component = static_cast<int>(part.first + i);
    const Value value = values ? Value(values->values[i]) : new_value(node, {}, component);
    const double* const number = std::get_if<double>(&value);
    if (number == nullptr) throw text::Error(node.value->place, "an array holds numbers, not strings");
    host_.assign(id, part.first + i, *number);
  }
}

Flow Runner::run(const Assignment& node) {
  if (const auto* part = std::get_if<ArrayUse>(&node.target)) {
    const Array* const array = host_.array(part->id);
    if (array == nullptr) throw text::Error("this is no array: it takes no index");
    assign_array(node, part->id, part->indices, *array);
    return {};
  }
  if (const auto* id = std::get_if<VariableId>(&node.target); id != nullptr && host_.array(*id) != nullptr) {
    if (node.kind != AssignmentKind::set) throw text::Error("arrays are counted with number by number");
    assign_array(node, *id, {}, *host_.array(*id));
    return {};
  }
  if (const auto* id = std::get_if<VariableId>(&node.target);
      id != nullptr && std::holds_alternative<ArrayLiteral>(node.value->node)) {
    host_.set_shape(*id, evaluate_array(*node.value, evaluation_)->shape);
    assign_array(node, *id, {}, *host_.array(*id));
    return {};
  }
  Element element;
  int component = 0;
  const auto* const use = std::get_if<AttributeUse>(&node.target);
  if (use != nullptr) {
    element = evaluate_element(use->element, evaluation_);
    component = evaluate_component(*use, evaluation_);
  }
  Value value = new_value(node, element, component);
  if (const auto* id = std::get_if<VariableId>(&node.target)) {
    host_.assign(*id, std::move(value));
    if (node.permanent) host_.make_permanent(*id);
  } else if (const auto* internal = std::get_if<InternalId>(&node.target)) {
    host_.assign(*internal, value);
  } else if (const auto* local = std::get_if<LocalId>(&node.target)) {
    std::visit([&](auto& content) { evaluation_.local(*local) = std::move(content); }, value);
  } else {
    const double* const number = std::get_if<double>(&value);
    if (number == nullptr) throw text::Error(node.value->place, "an attribute is a number, not a string");
    host_.assign(use->attribute, element, component, *number);
  }
  return {};
}

Flow Runner::run(const ProcedureCall& node) {
  const Procedure* const procedure = host_.procedure(node.name);
  if (procedure == nullptr) throw text::Error(fmt::format("there is no procedure \"{}\"", node.name));
  std::vector<Value> arguments;
  for (const ExpressionPointer& argument : node.arguments)
    arguments.push_back(evaluate(*argument, evaluation_));
  call_procedure(*procedure, arguments, host_, evaluation_);
  return {};
}

Flow Runner::run(const Repetition& node) {
  const long count = evaluate_count(*node.count, evaluation_, "a number of repetitions");
  for (long i = 0; i < count; ++i) {
    const Flow flow = run(*node.body);
    if (flow.way != Way::on) return flow;
  }
  return {};
}

Flow Runner::run(const Loop& node) {
  if (node.begin) run(*node.begin);
  bool test = !node.body_first;
  while (true) {
    host_.between_statements();
    if (test && node.condition && !is_true(*node.condition, evaluation_)) return {};
    test = true;
    Flow flow = run(*node.body);
    if (!goes_on(flow)) return flow;
    if (node.next) run(*node.next);
  }
}

// The elements are those there are at the beginning; whether one is meant is asked when its turn comes.
Flow Runner::run(const Foreach& node) {
  std::vector<Element> elements;
  const Generator& generator = node.generator;
  if (generator.of) {
    const Element of = evaluate_element(*generator.of, evaluation_);
    elements = generator.single ? std::vector<Element>{of} : host_.parts(of, generator.kind);
  } else {
    elements = *host_.elements(generator.kind);
  }
  std::vector<double> numbers(elements.size());
  std::transform(elements.begin(), elements.end(), numbers.begin(),
                 [&](const Element& e) { return host_.number(e); });
  const std::uint64_t structure = host_.structure();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    Element element = elements[i];
    if (host_.structure() != structure) {
      const std::optional<Element> found = host_.numbered(generator.kind, numbers[i]);
      if (!found) continue;
      element = *found;
    }
    evaluation_.local(generator.slot) = element;
    if (generator.where && !is_true(*generator.where, evaluation_)) continue;
    Flow flow = run(*node.body);
    if (!goes_on(flow)) return flow;
  }
  return {};
}

Flow Runner::run(const Redirected& node) {
  const std::string target = evaluate_text(*node.target, evaluation_);
  host_.begin_redirection(node.kind, target);
  Flow flow;
  try {
    flow = run(*node.statement);
  } catch (...) {
    host_.cancel_redirection();
    throw;
  }
  host_.end_redirection();
  return flow;
}

// How far the stack has grown since the outermost run began.
std::ptrdiff_t stack_used(const Evaluation& evaluation) {
  const auto here = reinterpret_cast<std::intptr_t>(__builtin_frame_address(0));
  return std::abs(evaluation.stack_origin() - here);
}

}  // namespace

void execute(const Block& block, Host& host, Evaluation& evaluation) {
  const Evaluation::Frame frame(evaluation, block.slots);
  Runner(host, evaluation).run(block);
}

Value call_procedure(const Procedure& procedure, std::span<const Value> arguments, Host& host,
                     Evaluation& evaluation) {
  if (!procedure.body)
    throw text::Error(fmt::format("{} is declared, but its commands are not given yet", procedure.name));
  if (arguments.size() != procedure.parameters.size()) {
    throw text::Error(fmt::format("{} takes {} arguments now, not {}", procedure.name,
                                  procedure.parameters.size(), arguments.size()));
  }
  if (evaluation.frames() > deepest_calls || stack_used(evaluation) > most_stack) {
    throw text::Error(fmt::format("{} calls itself without end", procedure.name),
                      fmt::format("more than {} calls are open", evaluation.frames() - 1));
  }
  // A procedure may redefine itself while it runs.
  const std::shared_ptr<const Block> body = procedure.body;
  const Evaluation::Frame frame(evaluation, body->slots);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    LocalValue& local = evaluation.local(LocalId{static_cast<std::uint32_t>(i)});
    std::visit([&](const auto& content) { local = content; }, arguments[i]);
  }
  Runner runner(host, evaluation);
  runner.run(*body);
  return runner.returned;
}

}  // namespace lamella::language
