// A command's line, parsed by the command's table of arguments.
#pragma once

#include <memory>
#include <vector>

#include "language/evaluate.h"
#include "language/statement.h"
#include "language/statement_parser.h"
#include "session/command.h"

namespace lamella::session {

class Names;

// An argument as it was typed; which of the members are filled depends on its kind.
struct TypedArgument {
  const Argument* argument = nullptr;
  text::Place place;
  std::vector<language::ExpressionPointer> expressions;
  std::string word;  // a choice, a bare word, a procedure's or a new name
  std::optional<language::Generator> generator;
  std::optional<language::AttributeUse> attribute;
  std::string type;                                   // of a definition
  std::optional<language::ElementKind> attribute_of;  // of a definition
  Field field;
  std::shared_ptr<const language::Block> commands;
  std::optional<VertexFormulas> formulas;
};

// A command with its arguments.
struct Invocation : language::CommandCall {
  const Command* command = nullptr;
  std::vector<TypedArgument> arguments;
  // Values of the arguments, checked against the table.
  std::vector<Given> evaluate(language::Evaluation& evaluation) const;
};

// Takes the command's word and all that belongs to it. Throws text::Error naming what fits instead.
std::unique_ptr<const Invocation> parse_command_call(const Command& command, language::LexerStream& tokens,
                                                     Names& names);

}  // namespace lamella::session
