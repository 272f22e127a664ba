// Statements as trees. A body that is parsed once is shared by all who run it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "language/expression.h"
#include "language/procedure.h"

namespace lamella::language {

struct Statement;
using StatementPointer = std::unique_ptr<const Statement>;

// A command with its arguments, parsed. What is in it only those know who brought the command (session/).
class CommandCall {
 public:
  virtual ~CommandCall() = default;
};

struct Block {
  std::vector<StatementPointer> statements;
  std::uint32_t slots = 0;  // local values that a run needs; 0 in blocks inside others, which share theirs
};

enum class AssignmentKind : std::uint8_t { set, add, subtract, multiply, divide };

struct CommandStatement {
  std::unique_ptr<const CommandCall> call;
};
using AssignmentTarget = std::variant<VariableId, ArrayUse, LocalId, InternalId, AttributeUse>;
struct Assignment {
  AssignmentTarget target;
  AssignmentKind kind = AssignmentKind::set;
  bool permanent = false;  // ::=
  ExpressionPointer value;
};
// A command that is known and not supported; the message is for whoever runs it.
struct RefusedCommand {
  std::string message;
};
// A function called for what it does: `new_edge(1, 2)`.
struct ExpressionStatement {
  ExpressionPointer value;
};
struct ProcedureDefinition {
  Procedure procedure;
};
struct ProcedureCall {
  std::string name;
  std::vector<ExpressionPointer> arguments;
};
struct Repetition {
  StatementPointer body;
  ExpressionPointer count;
};
struct Conditionally {
  ExpressionPointer condition;
  StatementPointer yes;
  StatementPointer no;  // may be null
};
// while c do s; do s while c; for (begin; c; next) s
struct Loop {
  StatementPointer begin;       // may be null
  ExpressionPointer condition;  // null: for ever
  StatementPointer next;        // may be null
  StatementPointer body;
  bool body_first = false;
};
struct Foreach {
  Generator generator;
  StatementPointer body;
};
struct Break {
  int levels = 1;
};
struct Continue {
  int levels = 1;
};
struct Return {
  ExpressionPointer value;  // may be null
};
// local a, b
struct LocalDeclaration {
  std::vector<LocalId> ids;
};

enum class Redirection : std::uint8_t { overwrite, append, pipe };

struct Redirected {
  StatementPointer statement;
  Redirection kind = Redirection::overwrite;
  ExpressionPointer target;  // a file's name or a system command
};

struct Statement {
  std::variant<CommandStatement, RefusedCommand, ExpressionStatement, Assignment, ProcedureDefinition,
               ProcedureCall, Repetition, Conditionally, Loop, Foreach, Break, Continue, Return,
               LocalDeclaration, Redirected, Block>
      node;
  text::Place place;
};

template <class Node>
StatementPointer make_statement(Node node, text::Place place) {
  auto result = std::make_unique<Statement>();
  result->node = std::move(node);
  result->place = std::move(place);
  return result;
}

}  // namespace lamella::language
