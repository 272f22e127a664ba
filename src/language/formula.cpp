#include "language/formula.h"

#include <algorithm>

#include "language/function_derivatives.h"
#include "language/functions.h"
#include "language/jet.h"
#include "text/error.h"

namespace lamella::language {

// Instruction i writes register i; operands are earlier registers.
struct Formula::Program {
  enum class Kind : std::uint8_t {
    constant,
    coordinate,
    time,
    gravity,
    attribute,
    variable,
    negate,
    logical_not,
    unary,
    binary,
    operation,
    choose,
  };
  struct Instruction {
    Kind kind = Kind::constant;
    BinaryOperator operation = BinaryOperator::add;
    std::uint32_t a = 0;  // a register, or a row among coordinates, attributes or variables
    std::uint32_t b = 0;
    std::uint32_t c = 0;
    double constant = 0;
    UnaryRule unary = nullptr;
    BinaryRule binary = nullptr;
  };
  std::vector<Instruction> instructions;
  std::vector<VariableId> variables;
};

namespace {

// The local slots of a FormulaScope: three coordinates, the time, the constant of gravity, the attributes,
// the coordinates by other names.
constexpr std::uint32_t time_slot = 3;
constexpr std::uint32_t gravity_slot = 4;
constexpr std::uint32_t first_attribute_slot = 5;

[[noreturn]] void refuse(const Expression& expression, std::string what) {
  throw text::Error(expression.place, std::move(what),
                    "a formula is made of coordinates, variables, vertex attributes, numbers and functions");
}

}  // namespace

namespace detail {

// Turns a tree into instructions.
template <class Program>
class Compiler {
 public:
  using Instruction = typename Program::Instruction;
  using Kind = typename Program::Kind;

  explicit Compiler(std::size_t attributes) : attributes_(static_cast<std::uint32_t>(attributes)) {}

  std::uint32_t compile(const Expression& expression) {
    return std::visit([&](const auto& node) { return node_of(expression, node); }, expression.node);
  }
  Program take() { return std::move(program_); }

 private:
  std::uint32_t emit(Instruction instruction) {
    program_.instructions.push_back(instruction);
    return static_cast<std::uint32_t>(program_.instructions.size() - 1);
  }
  std::uint32_t emit(Kind kind, std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    Instruction i;
    i.kind = kind;
    i.a = a;
    i.b = b;
    i.c = c;
    return emit(i);
  }
  std::uint32_t emit(BinaryOperator operation, std::uint32_t a, std::uint32_t b) {
    Instruction i;
    i.kind = Kind::operation;
    i.operation = operation;
    i.a = a;
    i.b = b;
    return emit(i);
  }

  std::uint32_t node_of(const Expression&, const Number& node) {
    Instruction i;
    i.constant = node.value;
    return emit(i);
  }
  std::uint32_t node_of(const Expression&, const VariableUse& node) {
    auto& variables = program_.variables;
    const auto at = std::find(variables.begin(), variables.end(), node.id);
    const auto row = static_cast<std::uint32_t>(at - variables.begin());
    if (at == variables.end()) variables.push_back(node.id);
    return emit(Kind::variable, row);
  }
  std::uint32_t node_of(const Expression&, const LocalUse& node) {
    const std::uint32_t slot = node.id.slot;
    if (slot < time_slot) return emit(Kind::coordinate, slot);
    if (slot == time_slot) return emit(Kind::time, 0);
    if (slot == gravity_slot) return emit(Kind::gravity, 0);
    const std::uint32_t attribute = slot - first_attribute_slot;
    return attribute < attributes_ ? emit(Kind::attribute, attribute)
                                   : emit(Kind::coordinate, attribute - attributes_);
  }
  std::uint32_t node_of(const Expression&, const Unary& node) {
    const std::uint32_t operand = compile(*node.operand);
    return emit(node.operation == UnaryOperator::negate ? Kind::negate : Kind::logical_not, operand);
  }
  std::uint32_t node_of(const Expression&, const Chain& node) {
    std::uint32_t left = compile(*node.first);
    for (const Chain::Link& link : node.links) left = emit(link.operation, left, compile(*link.operand));
    return left;
  }
  std::uint32_t node_of(const Expression&, const Comparison& node) {
    const std::uint32_t left = compile(*node.left);
    return emit(node.operation, left, compile(*node.right));
  }
  std::uint32_t node_of(const Expression&, const Conditional& node) {
    const std::uint32_t condition = compile(*node.condition);
    const std::uint32_t yes = compile(*node.yes);
    return emit(Kind::choose, condition, yes, compile(*node.no));
  }
  std::uint32_t node_of(const Expression& expression, const Call& node) {
    Instruction i;
    i.a = compile(*node.arguments[0]);
    if (node.arguments.size() == 1) {
      i.kind = Kind::unary;
      i.unary = unary_rule(node.function->name);
    } else {
      i.kind = Kind::binary;
      i.b = compile(*node.arguments[1]);
      i.binary = binary_rule(node.function->name);
    }
    if (i.unary == nullptr && i.binary == nullptr) {
      refuse(expression,
             std::string(node.function->name) + " cannot stand in a formula: its derivatives are not known");
    }
    return emit(i);
  }
  template <class Other>
  std::uint32_t node_of(const Expression& expression, const Other&) {
    refuse(expression, "this cannot stand in a formula");
  }

  std::uint32_t attributes_;
  Program program_;
};

}  // namespace detail

Formula::Formula(std::shared_ptr<const Expression> expression, std::string text,
                 std::vector<std::string> attributes)
    : text_(std::move(text)), attributes_(std::move(attributes)) {
  detail::Compiler<Program> compiler(attributes_.size());
  compiler.compile(*expression);
  program_ = std::make_shared<const Program>(compiler.take());
  variables_.resize(program_->variables.size());
}

bool Formula::depends_on_time() const {
  return program_ && std::any_of(program_->instructions.begin(), program_->instructions.end(),
                                 [](const Program::Instruction& i) { return i.kind == Program::Kind::time; });
}

bool Formula::depends_on_variables() const {
  return program_ && !program_->variables.empty();
}

std::span<const VariableId> Formula::variables() const {
  return program_ ? std::span<const VariableId>(program_->variables) : std::span<const VariableId>{};
}

void Formula::bind(const Variables& variables, double gravity) {
  gravity_ = gravity;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const Variable* const variable = variables.get(program_->variables[i]);
    const double* const number = variable != nullptr ? std::get_if<double>(&variable->value) : nullptr;
    variables_[i] = number != nullptr ? *number : 0.0;
  }
}

namespace {

template <class Scalar>
Scalar constant(double value) {
  if constexpr (std::is_same_v<Scalar, double>) {
    return value;
  } else {
    Scalar result;
    result.value = value;
    return result;
  }
}

template <class Scalar>
Scalar coordinate(const FormulaInputs& inputs, std::uint32_t row) {
  Scalar result = constant<Scalar>(inputs.coordinates[row]);
  if constexpr (!std::is_same_v<Scalar, double>) {
    for (std::size_t k = 0; k < 3; ++k) result.gradient[k] = inputs.by[k] == static_cast<int>(row) ? 1 : 0;
  }
  return result;
}

constexpr std::size_t most_registers_on_stack = 64;

}  // namespace

template <class Scalar>
Scalar Formula::run(const FormulaInputs& inputs) const {
  const auto& instructions = program_->instructions;
  std::array<Scalar, most_registers_on_stack> few;
  std::vector<Scalar> many;
  if (instructions.size() > few.size()) many.resize(instructions.size());
  Scalar* const r = many.empty() ? few.data() : many.data();
  using Kind = Program::Kind;
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const Program::Instruction& in = instructions[i];
    switch (in.kind) {
      case Kind::constant:
        r[i] = constant<Scalar>(in.constant);
        break;
      case Kind::coordinate:
        r[i] = coordinate<Scalar>(inputs, in.a);
        break;
      case Kind::time:
        r[i] = constant<Scalar>(inputs.time);
        break;
      case Kind::gravity:
        r[i] = constant<Scalar>(gravity_);
        break;
      case Kind::attribute:
        r[i] = constant<Scalar>(inputs.attributes[in.a]);
        break;
      case Kind::variable:
        r[i] = constant<Scalar>(variables_[in.a]);
        break;
      case Kind::negate:
        r[i] = compose(r[in.a], -value_of(r[in.a]), -1, 0);
        break;
      case Kind::logical_not:
        r[i] = constant<Scalar>(value_of(r[in.a]) == 0 ? 1 : 0);
        break;
      case Kind::unary: {
        const UnaryDerivatives d = in.unary(value_of(r[in.a]));
        r[i] = compose(r[in.a], d.f, d.first, d.second);
        break;
      }
      case Kind::binary:
        r[i] = compose(r[in.a], r[in.b], in.binary(value_of(r[in.a]), value_of(r[in.b])));
        break;
      case Kind::operation:
        r[i] = compose(r[in.a], r[in.b], operator_rule(in.operation, value_of(r[in.a]), value_of(r[in.b])));
        break;
      case Kind::choose:
        r[i] = value_of(r[in.a]) != 0 ? r[in.b] : r[in.c];
        break;
    }
  }
  return r[instructions.size() - 1];
}

double Formula::value(const FormulaInputs& inputs) const {
  return run<double>(inputs);
}

Jet Formula::gradient(const FormulaInputs& inputs) const {
  const FirstJet first = run<FirstJet>(inputs);
  return {first.value, first.gradient, {}};
}

Jet Formula::hessian(const FormulaInputs& inputs) const {
  return run<Jet>(inputs);
}

}  // namespace lamella::language
