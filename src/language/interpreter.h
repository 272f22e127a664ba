// Runs statements.
#pragma once

#include "language/evaluate.h"
#include "language/statement.h"

namespace lamella::language {

// What statements act on.
class Host : public Environment {
 public:
  virtual void assign(VariableId id, Value value) = 0;
  // The variable outlives the scene.
  virtual void make_permanent(VariableId id) = 0;
  // Makes a variable an array of this shape, with what fits of an array that it was.
  virtual void set_shape(VariableId id, const std::vector<int>& shape) = 0;
  // A component of a variable that is an array, in row order.
  virtual void assign(VariableId id, std::size_t component, double value) = 0;
  virtual void assign(InternalId id, const Value& value) = 0;
  virtual void assign(AttributeId id, const Element& element, int component, double value) = 0;

  virtual const Procedure* procedure(const std::string& name) = 0;
  virtual void define(const Procedure& procedure) = 0;
  virtual void run_command(const CommandCall& call, Evaluation& evaluation) = 0;

  // Sends output elsewhere until the matching `end_redirection`, which writes what is still to be written.
  virtual void begin_redirection(Redirection kind, const std::string& target) = 0;
  virtual void end_redirection() = 0;
  // Drops what a statement that failed has written there.
  virtual void cancel_redirection() = 0;

  // Called between statements; throws to stop the run.
  virtual void between_statements() = 0;

  // Changes whenever elements may have moved to other rows. Numbers stay.
  virtual std::uint64_t structure() = 0;
  virtual double number(const Element& element) = 0;
};

// Runs a statement of the top level, or the body of a procedure without arguments.
void execute(const Block& block, Host& host, Evaluation& evaluation);

// Runs a procedure or function; returns what it returns, 0 if nothing. An endless recursion ends in
// text::Error.
Value call_procedure(const Procedure& procedure, std::span<const Value> arguments, Host& host,
                     Evaluation& evaluation);

}  // namespace lamella::language
