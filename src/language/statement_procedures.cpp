// Procedures: their definitions and calls, as StatementParser takes them.
#include <array>
#include <utility>

#include <fmt/format.h>

#include "language/letters.h"
#include "language/statement_parser.h"
#include "text/suggest.h"

namespace lamella::language {

// Parses a body with its own local names. `source` becomes its text.
std::shared_ptr<const Block> StatementParser::body(const std::vector<std::string>& parameter_names,
                                                   std::string& source) {
  const Locals outer = std::exchange(scope_.locals(), {});
  const int outer_loops = std::exchange(loops_, 0);
  auto result = std::make_shared<Block>();
  const auto restore = [&] {
    scope_.locals() = outer;
    loops_ = outer_loops;
  };
  try {
    for (const std::string& name : parameter_names) scope_.locals().declare(name);
    const text::Place begin = tokens_.peek().place;
    if (tokens_.peek().is_symbol("{")) {
      *result = braces();
    } else {
      result->statements.push_back(statement());
    }
    const std::uint32_t end = tokens_.previous_end();
    source = begin.source->content.substr(begin.offset, end - begin.offset);
    result->slots = scope_.locals().slots();
  } catch (...) {
    restore();
    throw;
  }
  restore();
  return result;
}

// name := { commands }
StatementPointer StatementParser::procedure_definition(const Token& name) {
  check_new_name(name);
  if (name.text.size() == 1 && scope_.is_command(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is a command", name.text),
                      "give procedures longer names");
  }
  if (scope_.internal(name.text))
    throw text::Error(name.place, fmt::format("\"{}\" is a value", name.text), "choose another name");
  scope_.promise_procedure(name.text, 0, false);
  ProcedureDefinition result;
  result.procedure.name = std::string(name.text);
  result.procedure.body = body({}, result.procedure.source);
  return make_statement(std::move(result), name.place);
}

// procedure name(real a, integer b) { commands }, function real name(...) { commands }; or `;` in place of
// the commands.
StatementPointer StatementParser::declared_procedure() {
  const bool is_function = tokens_.take().is_word("function");
  const auto type = [&] {
    const Token word = expect_name("a type: real or integer");
    if (!word.is_word("real") && !word.is_word("integer") && !word.is_word("string")) {
      throw text::Error(word.place, fmt::format("{} is no type", describe(word)),
                        "types are real, integer and string");
    }
    return text::lower(word.text);
  };
  if (is_function) type();
  const Token name = expect_name("a name");
  check_new_name(name);
  expect("(", "and the arguments");
  ProcedureDefinition result;
  std::vector<std::string> names;
  {
    const Brackets brackets(tokens_);
    while (!tokens_.peek().is_symbol(")")) {
      if (!names.empty()) expect(",", "or \")\"");
      const std::string argument_type = type();
      names.emplace_back(expect_name("an argument's name").text);
      result.procedure.parameters.push_back(argument_type + " " + names.back());
    }
    tokens_.take();
  }
  result.procedure.name = std::string(name.text);
  result.procedure.returns_value = is_function;
  scope_.promise_procedure(name.text, names.size(), is_function);
  if (!tokens_.peek().is_symbol(";")) {
    skip_lines();
    if (!tokens_.peek().is_symbol("{")) unexpected("\"{\" and the commands");
    result.procedure.body = body(names, result.procedure.source);
  }
  return make_statement(std::move(result), name.place);
}

// r :::= { commands }, or r :::= alone, which gives the letter its first meaning again.
StatementPointer StatementParser::letter_definition(const Token& name) {
  ProcedureDefinition result;
  result.procedure.name = letter_name(name.text);
  if (!at_command_end(tokens_)) {
    skip_lines();
    result.procedure.body = body({}, result.procedure.source);
    scope_.promise_procedure(result.procedure.name, 0, false);
  }
  return make_statement(std::move(result), name.place);
}

StatementPointer StatementParser::procedure_call() {
  const bool letter = is_redefined_letter();
  const Token name = tokens_.take();
  const std::string called = letter ? letter_name(name.text) : text::lower(name.text);
  const std::size_t wanted = *scope_.procedure(called);
  ProcedureCall result{text::lower(called), {}};
  if (tokens_.peek().is_symbol("(")) {
    tokens_.take();
    const Brackets brackets(tokens_);
    while (!tokens_.peek().is_symbol(")")) {
      if (!result.arguments.empty()) expect(",", "or \")\"");
      result.arguments.push_back(expression());
    }
    tokens_.take();
  }
  if (result.arguments.size() != wanted) {
    throw text::Error(name.place, fmt::format("{} takes {} argument{}, not {}", name.text, wanted,
                                              wanted == 1 ? "" : "s", result.arguments.size()));
  }
  StatementPointer call = make_statement(std::move(result), name.place);
  if (at_command_end(tokens_)) return call;
  return make_statement(Repetition{std::move(call), expression()}, name.place);
}

}  // namespace lamella::language
