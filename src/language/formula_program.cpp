#include "language/formula_program.h"

#include <algorithm>
#include <cmath>

#include "language/functions.h"
#include "text/error.h"

namespace lamella::language {

namespace {

// The local slots of a FormulaScope: three coordinates, the time, the constant of gravity, the attributes,
// the coordinates by other names.
constexpr std::uint32_t time_slot = 3;
constexpr std::uint32_t gravity_slot = 4;
constexpr std::uint32_t first_attribute_slot = 5;
constexpr double most_exponent = 64;  // of powers found by multiplication

[[noreturn]] void refuse(const Expression& expression, std::string what) {
  throw text::Error(expression.place, std::move(what),
                    "a formula is made of coordinates, variables, vertex attributes, numbers and functions");
}

// Turns a tree into instructions.
class Compiler {
 public:
  using Instruction = FormulaProgram::Instruction;
  using Kind = FormulaProgram::Kind;

  explicit Compiler(std::size_t attributes) : attributes_(static_cast<std::uint32_t>(attributes)) {}

  std::uint32_t compile(const Expression& expression) {
    return std::visit([&](const auto& node) { return node_of(expression, node); }, expression.node);
  }
  FormulaProgram take() { return std::move(program_); }

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
  static Kind kind_of(BinaryOperator operation) {
    switch (operation) {
      case BinaryOperator::add:
        return Kind::add;
      case BinaryOperator::subtract:
      case BinaryOperator::equate:
        return Kind::subtract;
      case BinaryOperator::multiply:
        return Kind::multiply;
      case BinaryOperator::divide:
        return Kind::divide;
      default:
        return Kind::operation;
    }
  }
  std::uint32_t emit(BinaryOperator operation, std::uint32_t a, std::uint32_t b) {
    Instruction i;
    i.kind = kind_of(operation);
    i.operation = operation;
    i.a = a;
    i.b = b;
    const Instruction& exponent = program_.instructions[b];
    if (operation == BinaryOperator::power && exponent.kind == Kind::constant &&
        exponent.constant == std::trunc(exponent.constant) && std::abs(exponent.constant) <= most_exponent) {
      i.kind = Kind::whole_power;
      i.exponent = static_cast<int>(exponent.constant);
    }
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
  FormulaProgram program_;
};

// Calls function(register) for the operands of an instruction.
template <class Function>
void for_each_operand(const FormulaProgram::Instruction& in, Function&& function) {
  using Kind = FormulaProgram::Kind;
  if (in.kind >= Kind::negate) function(in.a);
  const bool two = in.kind == Kind::binary || in.kind == Kind::operation || in.kind == Kind::choose ||
                   (in.kind >= Kind::add && in.kind <= Kind::divide);
  if (two) function(in.b);
  if (in.kind == Kind::choose) function(in.c);
}

void part(FormulaProgram& program) {
  using Kind = FormulaProgram::Kind;
  auto& [instructions, variables, uniform, varying, loaded] = program;
  const auto count = static_cast<std::uint32_t>(instructions.size());
  std::vector<std::uint8_t> varies(count, 0);
  std::vector<std::uint8_t> read(count, 0);
  read[count - 1] = 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const FormulaProgram::Instruction& in = instructions[i];
    varies[i] = in.kind == Kind::coordinate || in.kind == Kind::time || in.kind == Kind::attribute ? 1 : 0;
    for_each_operand(in, [&](std::uint32_t operand) { varies[i] |= varies[operand]; });
    (varies[i] != 0 ? varying : uniform).push_back(i);
    if (varies[i] != 0) for_each_operand(in, [&](std::uint32_t operand) { read[operand] = 1; });
  }
  for (const std::uint32_t i : uniform)
    if (read[i] != 0) loaded.push_back(i);
}

}  // namespace

FormulaProgram compile_formula(const Expression& expression, std::size_t attributes) {
  Compiler compiler(attributes);
  compiler.compile(expression);
  FormulaProgram program = compiler.take();
  part(program);
  return program;
}

}  // namespace lamella::language
