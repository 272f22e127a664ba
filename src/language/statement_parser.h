// Parses commands: what stands at the prompt, in a script or at the end of a datafile.
#pragma once

#include "language/expression_parser.h"
#include "language/statement.h"

namespace lamella::language {

// The scope of commands, which text may add to.
class StatementScope : public Scope {
 public:
  // The number of arguments of a procedure (or function) of this name.
  virtual std::optional<std::size_t> procedure(std::string_view name) const = 0;
  // From here on the text may use these names; they come to exist when it runs.
  virtual VariableId promise_variable(std::string_view name) = 0;
  virtual void promise_procedure(std::string_view name, std::size_t parameters, bool returns_value) = 0;

  // --- commands
  virtual bool is_command(std::string_view word) const = 0;
  // Why a command that is known is not supported; empty for others.
  virtual std::string why_refused(std::string_view word) const = 0;
  // Takes the command's word and its arguments.
  virtual std::unique_ptr<const CommandCall> parse_command(LexerStream& tokens) = 0;
  // Suggestions for what can begin a statement.
  virtual void collect_statement_words(std::vector<std::string>& into) const = 0;
};

// Whether a command ends before the next token: `;`, a line end, `}`, `)`, a redirection, `else` or `while`.
bool at_command_end(LexerStream& tokens);

// Whether a word of the language, such as foreach, is meant, in any case.
bool is_keyword(std::string_view word);

class StatementParser {
 public:
  StatementParser(LexerStream& tokens, StatementScope& scope) : tokens_(tokens), scope_(scope) {}

  // The next statement up to `;` or its line's end, ready to run; null at the end of the text. Throws
  // text::Error, or Incomplete where the text ends inside the statement.
  std::shared_ptr<const Block> next();
  // The same with its text.
  std::pair<std::shared_ptr<const Block>, std::string> next_with_text();
  // Whether the line that `next` has taken statements from is done.
  bool at_line_end();
  // From where a line begins that could not be parsed: passes over it, and over the lines that its brackets
  // hold.
  void skip_statement_line();

 private:
  class Level;

  StatementPointer listed();
  StatementPointer inner();
  StatementPointer statement();
  StatementPointer word_statement();
  StatementPointer keyword_statement();
  StatementPointer block_with_count();
  Block braces();
  StatementPointer assignment();
  StatementPointer assign_to(AssignmentTarget target);
  StatementPointer array_assignment();
  bool at_array_literal();
  bool at_named_setting();
  bool is_redefined_letter();
  StatementPointer letter_definition(const Token& name);
  bool at_global_definition();
  StatementPointer named_setting();
  StatementPointer refused(std::string_view reason);
  StatementPointer letter_with_count();
  bool is_letter_with_count(const Token& word) const;
  Assignment assigned_value();
  StatementPointer assign_name(const Token& name);
  StatementPointer step(const Token& name, const text::Place& place, bool up);
  StatementPointer attribute_assignment();
  bool value_is_command();
  StatementPointer procedure_definition(const Token& name);
  StatementPointer declared_procedure();
  std::shared_ptr<const Block> body(const std::vector<std::string>& parameter_names, std::string& source);
  StatementPointer procedure_call();
  StatementPointer conditionally();
  StatementPointer while_loop();
  StatementPointer do_loop();
  StatementPointer for_loop();
  StatementPointer foreach_loop();
  StatementPointer leave(bool is_break);
  StatementPointer return_statement();
  StatementPointer local_declaration();
  StatementPointer redirected(StatementPointer statement);
  bool else_ahead();

  ExpressionParser expressions() { return {tokens_, scope_, ExpressionStyle::command}; }
  ExpressionPointer expression() { return expressions().expression(); }
  ExpressionPointer condition() {
    return ExpressionParser(tokens_, scope_, ExpressionStyle::condition).expression();
  }
  bool accept_word(std::string_view word);
  bool accept(std::string_view symbol);
  Token expect(std::string_view symbol, std::string_view context);
  Token expect_name(std::string_view what);
  void skip_lines();
  void check_new_name(const Token& name);
  [[noreturn]] void unexpected(std::string_view wanted);

  LexerStream& tokens_;
  StatementScope& scope_;
  int depth_ = 0;
  int loops_ = 0;
};

}  // namespace lamella::language
