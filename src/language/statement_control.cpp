// Choices and loops, as StatementParser takes them.
#include <utility>

#include <fmt/format.h>

#include "language/statement_parser.h"

namespace lamella::language {

// Whether an else follows, be it after a semicolon or on a later line of the same text.
bool StatementParser::else_ahead() {
  std::size_t ahead = 0;
  if (tokens_.peek().is_symbol(";")) ++ahead;
  while (tokens_.peek(ahead).is(TokenKind::newline)) ++ahead;
  if (!tokens_.peek(ahead).is_word("else")) return false;
  for (std::size_t i = 0; i <= ahead; ++i) tokens_.take();
  return true;
}

StatementPointer StatementParser::conditionally() {
  const Token keyword = tokens_.take();
  Conditionally result;
  result.condition = condition();
  if (!accept_word("then") && tokens_.peek().is(TokenKind::newline)) {
    skip_lines();
    accept_word("then");
  }
  result.yes = redirected(inner());
  if (else_ahead()) result.no = inner();
  return make_statement(std::move(result), keyword.place);
}

StatementPointer StatementParser::while_loop() {
  const Token keyword = tokens_.take();
  Loop result;
  result.condition = condition();
  skip_lines();
  accept_word("do");
  ++loops_;
  result.body = inner();
  --loops_;
  return make_statement(std::move(result), keyword.place);
}

StatementPointer StatementParser::do_loop() {
  const Token keyword = tokens_.take();
  Loop result;
  result.body_first = true;
  ++loops_;
  result.body = inner();
  --loops_;
  accept(";");
  skip_lines();
  if (!accept_word("while")) unexpected("\"while\" and a condition");
  result.condition = expression();
  return make_statement(std::move(result), keyword.place);
}

StatementPointer StatementParser::for_loop() {
  const Token keyword = tokens_.take();
  Loop result;
  {
    expect("(", "as in for (i := 1; i <= 10; i++)");
    const Brackets brackets(tokens_);
    if (!tokens_.peek().is_symbol(";")) result.begin = statement();
    expect(";", "and a condition");
    if (!tokens_.peek().is_symbol(";")) result.condition = condition();
    expect(";", "and what is done after each round");
    if (!tokens_.peek().is_symbol(")")) result.next = statement();
    expect(")", "");
  }
  ++loops_;
  result.body = inner();
  --loops_;
  return make_statement(std::move(result), keyword.place);
}

StatementPointer StatementParser::foreach_loop() {
  const Token keyword = tokens_.take();
  const LocalNames names(scope_);
  Foreach result{expressions().generator(), nullptr};
  skip_lines();
  accept_word("do");
  ++loops_;
  result.body = inner();
  --loops_;
  return make_statement(std::move(result), keyword.place);
}

StatementPointer StatementParser::leave(bool is_break) {
  const Token keyword = tokens_.take();
  int levels = 1;
  if (tokens_.peek().is(TokenKind::number)) {
    const Token number = tokens_.take();
    if (number.number != static_cast<int>(number.number) || number.number < 1) {
      throw text::Error(number.place, fmt::format("{} loops cannot be left", number.text));
    }
    levels = static_cast<int>(number.number);
  }
  if (levels > loops_) {
    throw text::Error(keyword.place,
                      fmt::format("{} stands in {} loop{}", keyword.text, loops_, loops_ == 1 ? "" : "s"),
                      loops_ == 0 ? "it has a meaning in while, do, for and foreach only" : "");
  }
  if (is_break) return make_statement(Break{levels}, keyword.place);
  return make_statement(Continue{levels}, keyword.place);
}

StatementPointer StatementParser::return_statement() {
  const Token keyword = tokens_.take();
  Return result;
  if (!at_command_end(tokens_)) result.value = expression();
  return make_statement(std::move(result), keyword.place);
}

StatementPointer StatementParser::local_declaration() {
  const Token keyword = tokens_.take();
  LocalDeclaration result;
  do {
    const Token name = expect_name("a name");
    check_new_name(name);
    result.ids.push_back(scope_.locals().declare(name.text));
  } while (accept(","));
  return make_statement(std::move(result), keyword.place);
}

}  // namespace lamella::language
