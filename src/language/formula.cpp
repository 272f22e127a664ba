#include "language/formula.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "language/formula_program.h"
#include "language/jet.h"

namespace lamella::language {

Formula::Formula(std::shared_ptr<const Expression> expression, std::string text,
                 std::vector<std::string> attributes)
    : text_(std::move(text)), attributes_(std::move(attributes)) {
  program_ = std::make_shared<const FormulaProgram>(compile_formula(*expression, attributes_.size()));
  find_uniform(std::vector<double>(program_->variables.size()), 0);
}

bool Formula::depends_on_time() const {
  return program_ && std::any_of(program_->instructions.begin(), program_->instructions.end(),
                                 [](const FormulaProgram::Instruction& i) {
                                   return i.kind == FormulaProgram::Kind::time;
                                 });
}

bool Formula::depends_on_variables() const {
  return program_ && !program_->variables.empty();
}

std::span<const VariableId> Formula::variables() const {
  return program_ ? std::span<const VariableId>(program_->variables) : std::span<const VariableId>{};
}

void Formula::bind(const Variables& variables, double gravity) {
  if (!program_) return;
  std::vector<double> values;
  for (const VariableId id : program_->variables) {
    const Variable* const variable = variables.get(id);
    const double* const number = variable != nullptr ? std::get_if<double>(&variable->value) : nullptr;
    values.push_back(number != nullptr ? *number : 0.0);
  }
  find_uniform(values, gravity);
}

namespace {

constexpr std::size_t most_registers_on_stack = 64;

// Room for registers, not initialised: each is written before it is read.
template <class Scalar>
class Registers {
 public:
  explicit Registers(std::size_t count) {
    if (count <= most_registers_on_stack) return;
    many_.resize(count);
    begin_ = many_.data();
  }
  Scalar& operator[](std::size_t i) { return begin_[i]; }

 private:
  static_assert(std::is_trivially_copyable_v<Scalar>);
  alignas(64) std::array<std::byte, most_registers_on_stack * sizeof(Scalar)> few_;
  std::vector<Scalar> many_;
  Scalar* begin_ = reinterpret_cast<Scalar*>(few_.data());
};

struct LaneInputs {
  const std::array<Lanes, 3>& coordinates;
  double time = 0;
};

// --- inputs

template <class Scalar>
Scalar coordinate(const FormulaInputs& inputs, std::uint32_t row) {
  Scalar result = constant<Scalar>(inputs.coordinates[row]);
  if constexpr (!std::is_same_v<Scalar, double>) {
    for (std::size_t k = 0; k < 3; ++k) result.gradient[k] = inputs.by[k] == static_cast<int>(row) ? 1 : 0;
  }
  return result;
}

template <class Scalar>
Scalar coordinate(const LaneInputs& inputs, std::uint32_t row) {
  return inputs.coordinates[row];
}

double attribute(const FormulaInputs& inputs, std::uint32_t row) {
  return inputs.attributes[row];
}
double attribute(const LaneInputs&, std::uint32_t) {
  return NAN;  // such formulas are not evaluated in lanes
}

// --- rules, lane by lane

Slopes<double> slopes_of(UnaryRule rule, double a) {
  return rule(a);
}
Slopes<Lanes> slopes_of(UnaryRule rule, const Lanes& a) {
  Slopes<Lanes> d;
  for (std::size_t i = 0; i < lane_count; ++i) {
    const UnaryDerivatives one = rule(a[i]);
    d.f[i] = one.f;
    d.first[i] = one.first;
    d.second[i] = one.second;
  }
  return d;
}

template <class Rule>
SecondOrder slopes_of(const Rule& rule, double a, double b) {
  return rule(a, b);
}
template <class Rule>
SlopesOfTwo<Lanes> slopes_of(const Rule& rule, const Lanes& a, const Lanes& b) {
  SlopesOfTwo<Lanes> d;
  for (std::size_t i = 0; i < lane_count; ++i) {
    const SecondOrder one = rule(a[i], b[i]);
    d.f[i] = one.f;
    d.a[i] = one.a;
    d.b[i] = one.b;
  }
  return d;
}

template <class T>
SlopesOfTwo<T> product(const T& a, const T& b) {
  return {a * b, b, a, number<T>(0), number<T>(1), number<T>(0)};
}

template <class T>
SlopesOfTwo<T> quotient(const T& a, const T& b) {
  const T q = number<T>(1) / b;
  return {a / b, q, -a * q * q, number<T>(0), -q * q, number<T>(2) * a * q * q * q};
}

// One where the lane is 0, else 0.
double inverted(double a) {
  return a == 0 ? 1 : 0;
}
Lanes inverted(const Lanes& a) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = inverted(a[i]);
  return r;
}

template <class Scalar>
Scalar flat(const typename NumberOf<Scalar>::type& value) {
  Scalar r = constant<Scalar>(0);
  if constexpr (std::is_same_v<Scalar, typename NumberOf<Scalar>::type>) {
    r = value;
  } else {
    r.value = value;
  }
  return r;
}

template <class Scalar>
Scalar chosen(double condition, const Scalar& yes, const Scalar& no) {
  return condition != 0 ? yes : no;
}
Lanes chosen(const Lanes& condition, const Lanes& yes, const Lanes& no) {
  Lanes r;
  for (std::size_t i = 0; i < lane_count; ++i) r[i] = condition[i] != 0 ? yes[i] : no[i];
  return r;
}

// What one instruction of those that have operands makes of registers.
template <class Scalar>
Scalar operate(const FormulaProgram::Instruction& in, Registers<Scalar>& r) {
  using Kind = FormulaProgram::Kind;
  const Scalar& a = r[in.a];
  const Scalar& b = r[in.b];
  switch (in.kind) {
    case Kind::negate:
      return negative(a);
    case Kind::logical_not:
      return flat<Scalar>(inverted(value_of(a)));
    case Kind::add:
      return sum(a, b);
    case Kind::subtract:
      return sum(a, negative(b));
    case Kind::multiply:
      return compose(a, b, product(value_of(a), value_of(b)));
    case Kind::divide:
      return compose(a, b, quotient(value_of(a), value_of(b)));
    case Kind::whole_power:
      return raised(a, in.exponent);
    case Kind::unary:
      return compose(a, slopes_of(in.unary, value_of(a)));
    case Kind::binary:
      return compose(a, b, slopes_of(in.binary, value_of(a), value_of(b)));
    case Kind::choose:
      return chosen(value_of(a), b, r[in.c]);
    default: {
      const auto rule = [&](double x, double y) { return operator_rule(in.operation, x, y); };
      return compose(a, b, slopes_of(rule, value_of(a), value_of(b)));
    }
  }
}

// Fills all registers that the result depends on.
template <class Scalar, class Inputs>
void run(const FormulaProgram& program, std::span<const double> uniform, const Inputs& inputs,
         Registers<Scalar>& r) {
  for (std::size_t k = 0; k < program.loaded.size(); ++k) r[program.loaded[k]] = constant<Scalar>(uniform[k]);
  using Kind = FormulaProgram::Kind;
  for (const std::uint32_t i : program.varying) {
    const FormulaProgram::Instruction& in = program.instructions[i];
    if (in.kind == Kind::coordinate) {
      r[i] = coordinate<Scalar>(inputs, in.a);
    } else if (in.kind == Kind::time) {
      r[i] = constant<Scalar>(inputs.time);
    } else if (in.kind == Kind::attribute) {
      r[i] = constant<Scalar>(attribute(inputs, in.a));
    } else {
      r[i] = operate(in, r);
    }
  }
}

template <class Scalar, class Inputs>
Scalar result_of(const FormulaProgram& program, std::span<const double> uniform, const Inputs& inputs) {
  Registers<Scalar> r(program.instructions.size());
  run(program, uniform, inputs, r);
  return r[program.instructions.size() - 1];
}

// --- derivatives backward: of the result by each register

// What reaches an operand. Where nothing comes nothing goes, not even times an infinite slope: it belongs to
// a branch that was not taken.
void pass_on(Lanes& to, const Lanes& from, const Lanes& slope) {
  for (std::size_t i = 0; i < lane_count; ++i) to[i] += from[i] != 0 ? from[i] * slope[i] : 0;
}
void pass_on(Lanes& to, const Lanes& from, const SlopesOfTwo<Lanes>& d, Lanes& other) {
  pass_on(to, from, d.a);
  pass_on(other, from, d.b);
}

Lanes power_slope(const Lanes& a, int n) {
  if (n == 0) return {};
  return n == 2 ? a + a : number<Lanes>(n) * whole_power(a, n - 1);
}

// Hands the derivative by an instruction's register on to those of its operands.
void hand_back(const FormulaProgram::Instruction& in, Registers<Lanes>& r, const Lanes& from,
               Registers<Lanes>& by) {
  using Kind = FormulaProgram::Kind;
  Lanes& a = by[in.a];
  Lanes& b = by[in.b];
  switch (in.kind) {
    case Kind::logical_not:
      return;
    case Kind::negate:
      a = a - from;
      return;
    case Kind::add:
      a = a + from;
      b = b + from;
      return;
    case Kind::subtract:
      a = a + from;
      b = b - from;
      return;
    case Kind::multiply:
      return pass_on(a, from, product(r[in.a], r[in.b]), b);
    case Kind::divide:
      return pass_on(a, from, quotient(r[in.a], r[in.b]), b);
    case Kind::whole_power:
      return pass_on(a, from, power_slope(r[in.a], in.exponent));
    case Kind::unary:
      return pass_on(a, from, slopes_of(in.unary, r[in.a]).first);
    case Kind::binary:
      return pass_on(a, from, slopes_of(in.binary, r[in.a], r[in.b]), b);
    case Kind::choose: {
      const Lanes none{};
      b = b + chosen(r[in.a], from, none);
      by[in.c] = by[in.c] + chosen(r[in.a], none, from);
      return;
    }
    default: {
      const auto rule = [&](double x, double y) { return operator_rule(in.operation, x, y); };
      return pass_on(a, from, slopes_of(rule, r[in.a], r[in.b]), b);
    }
  }
}

// One pass back over the instructions, whatever the number of coordinates: forward, every instruction would
// carry four numbers a lane.
First<Lanes> gradient_backward(const FormulaProgram& program, std::span<const double> uniform,
                               const LaneInputs& inputs) {
  using Kind = FormulaProgram::Kind;
  const std::size_t count = program.instructions.size();
  Registers<Lanes> r(count);
  run(program, uniform, inputs, r);
  Registers<Lanes> by(count);
  for (std::size_t i = 0; i < count; ++i) by[i] = {};
  by[count - 1] = number<Lanes>(1);
  First<Lanes> result{r[count - 1], {}};
  for (auto at = program.varying.rbegin(); at != program.varying.rend(); ++at) {
    const FormulaProgram::Instruction& in = program.instructions[*at];
    if (in.kind == Kind::coordinate) {
      result.gradient[in.a] = result.gradient[in.a] + by[*at];
    } else if (in.kind != Kind::time && in.kind != Kind::attribute) {
      hand_back(in, r, by[*at], by);
    }
  }
  return result;
}

}  // namespace

void Formula::find_uniform(std::span<const double> variables, double gravity) {
  const FormulaProgram& program = *program_;
  Registers<double> r(program.instructions.size());
  using Kind = FormulaProgram::Kind;
  for (const std::uint32_t i : program.uniform) {
    const FormulaProgram::Instruction& in = program.instructions[i];
    if (in.kind == Kind::constant) {
      r[i] = in.constant;
    } else if (in.kind == Kind::gravity) {
      r[i] = gravity;
    } else if (in.kind == Kind::variable) {
      r[i] = variables[in.a];
    } else {
      r[i] = operate(in, r);
    }
  }
  uniform_.clear();
  for (const std::uint32_t i : program.loaded) uniform_.push_back(r[i]);
}

double Formula::value(const FormulaInputs& inputs) const {
  return result_of<double>(*program_, uniform_, inputs);
}

Jet Formula::gradient(const FormulaInputs& inputs) const {
  const auto first = result_of<First<double>>(*program_, uniform_, inputs);
  return {first.value, first.gradient, {}};
}

Jet Formula::hessian(const FormulaInputs& inputs) const {
  return result_of<Jet>(*program_, uniform_, inputs);
}

Lanes Formula::values(const std::array<Lanes, 3>& coordinates, double time) const {
  return result_of<Lanes>(*program_, uniform_, LaneInputs{coordinates, time});
}

First<Lanes> Formula::gradients(const std::array<Lanes, 3>& coordinates, double time) const {
  return gradient_backward(*program_, uniform_, LaneInputs{coordinates, time});
}

}  // namespace lamella::language
