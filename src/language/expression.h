// Expressions as trees. Each node knows its place, so that whatever goes wrong in evaluating is shown where
// it stands.
//
// Names are resolved when the text is parsed: a node holds the row of a variable, not its name. What looks a
// value up when the expression runs is the environment (evaluate.h).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "language/elements.h"
#include "language/variables.h"
#include "text/source.h"

namespace lamella::language {

struct Expression;
struct Function;  // functions.h
using ExpressionPointer = std::unique_ptr<const Expression>;

// --- what names stand for
// A slot among the local values of the running procedure (or top-level statement).
struct LocalId {
  std::uint32_t slot = 0;
};
// A row of the environment's table of internal variables (`total_area`).
struct InternalId {
  std::uint32_t row = 0;
};
// A row of the environment's table of attributes (`x` of vertices, `length` of edges).
struct AttributeId {
  std::uint32_t row = 0;
};

// --- elements
struct Generator;

// One element: `vv`, `vertex[3]`, `facet[2].edge[1]`.
struct ElementPath {
  struct Step {
    ElementKind kind = ElementKind::vertex;
    ExpressionPointer index;  // counted from 1
    text::Place place;
  };
  // The element in a slot, or else one by number.
  std::optional<LocalId> local;
  ElementKind root_kind = ElementKind::vertex;
  ExpressionPointer number;
  std::vector<Step> steps;
  text::Place place;

  ElementKind kind() const { return steps.empty() ? root_kind : steps.back().kind; }
};

// Elements one after the other: `vertex`, `edge ee where ee.length > 1`, `facet[2].edge`, `vertex[3]`.
struct Generator {
  ElementKind kind = ElementKind::vertex;
  std::optional<ElementPath> of;  // the element whose parts are meant, or the one element itself
  bool single = false;            // just the element `of`
  LocalId slot;                   // where the element in turn is found
  ExpressionPointer where;        // may be null
  text::Place place;
};

// --- nodes
enum class UnaryOperator : std::uint8_t { negate, logical_not };
enum class BinaryOperator : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  modulus,          // x - floor(x/y) y
  integer_modulus,  // the same of floor(x), floor(y)
  integer_divide,   // of both rounded towards zero, rounded towards zero
  power,
  equal,
  not_equal,
  less,
  greater,
  less_equal,
  greater_equal,
  logical_and,
  logical_or,
  equate,  // `=`: a minus that binds last
};
enum class AggregateKind : std::uint8_t { sum, minimum, maximum, average, count };

struct Number {
  double value = 0;
};
struct Text {
  std::string content;
};
struct VariableUse {
  VariableId id;
};
// {1, 2, 3} or {{1, 2}, {3, 4}}: only as what is assigned to an array.
struct ArrayLiteral {
  std::vector<ExpressionPointer> items;
};
struct LocalUse {
  LocalId id;
};
// `costs[2][3]`: a variable that is an array. With fewer indices than dimensions it is an array again.
struct ArrayUse {
  VariableId id;
  std::vector<ExpressionPointer> indices;
};
struct InternalUse {
  InternalId id;
};
// `vertex[3].x`, `length` of the element in turn. With fewer indices than dimensions it is an array.
struct AttributeUse {
  ElementPath element;
  AttributeId attribute;
  std::vector<int> shape;
  std::vector<ExpressionPointer> indices;
};
struct Unary {
  UnaryOperator operation = UnaryOperator::negate;
  ExpressionPointer operand;
};
// a - b + c: operators of one rank, applied from the left. A list, so that long sums need no depth.
struct Chain {
  struct Link {
    BinaryOperator operation = BinaryOperator::add;
    ExpressionPointer operand;
    text::Place place;  // of the operator
  };
  ExpressionPointer first;
  std::vector<Link> links;
};
struct Comparison {
  BinaryOperator operation = BinaryOperator::equal;
  ExpressionPointer left;
  ExpressionPointer right;
};
struct Conditional {
  ExpressionPointer condition;
  ExpressionPointer yes;
  ExpressionPointer no;
};
struct Call {
  const Function* function = nullptr;
  std::vector<ExpressionPointer> arguments;
};
// A function that the user defined, or that acts on the scene; looked up by name when it is called.
struct UserCall {
  std::string name;
  std::vector<ExpressionPointer> arguments;
};
struct Aggregate {
  AggregateKind kind = AggregateKind::sum;
  Generator generator;
  ExpressionPointer value;  // null for count(elements)
};
// sprintf
struct Format {
  ExpressionPointer format;
  std::vector<ExpressionPointer> arguments;
};
// is_defined("name")
struct IsDefined {
  ExpressionPointer name;
};
// sizeof("text")
struct SizeOf {
  ExpressionPointer of;
};
// valid_element(edge[12])
struct ValidElement {
  ElementPath element;
};

struct Expression {
  std::variant<Number, Text, VariableUse, ArrayUse, ArrayLiteral, LocalUse, InternalUse, AttributeUse, Unary,
               Chain, Comparison, Conditional, Call, UserCall, Aggregate, Format, IsDefined, SizeOf,
               ValidElement>
      node;
  text::Place place;
};

}  // namespace lamella::language
