#include "language/statement_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "language/functions.h"
#include "text/suggest.h"

namespace lamella::language {

namespace {

constexpr int deepest = 200;

constexpr std::array<std::string_view, 14> keywords = {"if",    "then",      "else",     "while",    "do",
                                                       "for",   "foreach",   "break",    "continue", "return",
                                                       "local", "procedure", "function", "where"};

bool is_keyword(std::string_view word) {
  const std::string key = text::lower(word);
  return std::find(keywords.begin(), keywords.end(), key) != keywords.end();
}

std::optional<AssignmentKind> assignment_kind(const Token& token) {
  constexpr std::array<std::pair<std::string_view, AssignmentKind>, 5> symbols = {
      {{":=", AssignmentKind::set},
       {"+=", AssignmentKind::add},
       {"-=", AssignmentKind::subtract},
       {"*=", AssignmentKind::multiply},
       {"/=", AssignmentKind::divide}}};
  for (const auto& [symbol, kind] : symbols) {
    if (token.is_symbol(symbol)) return kind;
  }
  return std::nullopt;
}

// Whether the text behind a word makes an assignment of it. `show --x` is none: there a step ends the
// statement.
bool begins_assignment(std::string_view after) {
  for (const std::string_view symbol : {":=", "+=", "-=", "*=", "/="}) {
    if (after.starts_with(symbol)) return true;
  }
  if (!after.starts_with("++") && !after.starts_with("--")) return false;
  const std::size_t next = after.find_first_not_of(" \t", 2);
  return next == std::string_view::npos ||
         std::string_view(";})\r\n/").find(after[next]) != std::string_view::npos;
}

template <class Node>
StatementPointer make(Node node, text::Place place) {
  auto result = std::make_unique<Statement>();
  result->node = std::move(node);
  result->place = std::move(place);
  return result;
}

// Whether a statement ends with a brace, so that no semicolon is missed after it.
bool ends_with_brace(const Statement& statement) {
  if (std::holds_alternative<Block>(statement.node) ||
      std::holds_alternative<ProcedureDefinition>(statement.node))
    return true;
  if (const auto* conditionally = std::get_if<Conditionally>(&statement.node)) {
    return ends_with_brace(conditionally->no ? *conditionally->no : *conditionally->yes);
  }
  if (const auto* loop = std::get_if<Loop>(&statement.node))
    return !loop->body_first && ends_with_brace(*loop->body);
  if (const auto* foreach = std::get_if<Foreach>(&statement.node)) return ends_with_brace(*foreach->body);
  return false;
}

}  // namespace

bool at_command_end(LexerStream& tokens) {
  const Token& token = tokens.peek();
  if (token.ends_line() || token.is_word("else") || token.is_word("while") || token.is_word("then"))
    return true;
  constexpr std::array<std::string_view, 6> symbols = {";", "}", ")", ">>", ">>>", "|"};
  for (const std::string_view symbol : symbols) {
    if (token.is_symbol(symbol)) return true;
  }
  return token.is_symbol(">") && tokens.peek(1).is(TokenKind::string);
}

// Counts how deep statements are nested.
class StatementParser::Level {
 public:
  explicit Level(StatementParser& parser) : parser_(parser) {
    if (++parser_.depth_ <= deepest) return;
    --parser_.depth_;
    throw text::Error(parser_.tokens_.peek().place,
                      fmt::format("commands are nested more than {} levels deep", deepest));
  }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;
  ~Level() { --parser_.depth_; }

 private:
  StatementParser& parser_;
};

// --- tokens

void StatementParser::unexpected(std::string_view wanted) {
  const Token& found = tokens_.peek();
  const std::string message = fmt::format("expected {}, found {}", wanted, describe(found));
  if (found.is(TokenKind::end)) throw Incomplete(found.place, message);
  throw text::Error(found.place, message);
}

bool StatementParser::accept_word(std::string_view word) {
  if (!tokens_.peek().is_word(word)) return false;
  tokens_.take();
  return true;
}

bool StatementParser::accept(std::string_view symbol) {
  if (!tokens_.peek().is_symbol(symbol)) return false;
  tokens_.take();
  return true;
}

Token StatementParser::expect(std::string_view symbol, std::string_view context) {
  if (!tokens_.peek().is_symbol(symbol)) unexpected(fmt::format("\"{}\" {}", symbol, context));
  return tokens_.take();
}

Token StatementParser::expect_name(std::string_view what) {
  if (!tokens_.peek().is(TokenKind::word)) unexpected(what);
  return tokens_.take();
}

void StatementParser::skip_lines() {
  while (tokens_.peek().is(TokenKind::newline)) tokens_.take();
}

void StatementParser::skip_statement_line() {
  int open = 0;
  bool begun = false;
  while (true) {
    try {
      const Token token = tokens_.take();
      if (token.is(TokenKind::end)) return;
      if (token.is(TokenKind::newline) && begun && open <= 0) return;
      begun = begun || !token.is(TokenKind::newline);
      if (token.is_symbol("{") || token.is_symbol("(") || token.is_symbol("[")) ++open;
      if (token.is_symbol("}") || token.is_symbol(")") || token.is_symbol("]")) --open;
    } catch (const text::Error&) {
      begun = true;  // the lexer stands behind what it refused
    }
  }
}

// --- lists of statements

std::shared_ptr<const Block> StatementParser::next() {
  while (tokens_.peek().is(TokenKind::newline) || tokens_.peek().is_symbol(";")) tokens_.take();
  if (tokens_.peek().is(TokenKind::end)) return nullptr;
  const Locals outer = std::exchange(scope_.locals(), {});
  auto result = std::make_shared<Block>();
  try {
    result->statements.push_back(listed());
    result->slots = scope_.locals().slots();
  } catch (...) {
    scope_.locals() = outer;
    throw;
  }
  scope_.locals() = outer;
  const Token& after = tokens_.peek();
  if (after.ends_line() || after.is_symbol(";") || ends_with_brace(*result->statements.front()))
    return result;
  if (after.is_symbol("}")) throw text::Error(after.place, "this \"}\" closes nothing");
  if (after.is_symbol(")")) throw text::Error(after.place, "this \")\" closes nothing");
  throw text::Error(after.place, fmt::format("unexpected {}", describe(after)),
                    "commands on one line are separated by semicolons");
}

std::pair<std::shared_ptr<const Block>, std::string> StatementParser::next_with_text() {
  while (tokens_.peek().is(TokenKind::newline) || tokens_.peek().is_symbol(";")) tokens_.take();
  const text::Place begin = tokens_.peek().place;
  std::shared_ptr<const Block> block = next();
  const std::uint32_t length = block ? tokens_.previous_end() - begin.offset : 0;
  return {std::move(block), begin.source->content.substr(begin.offset, length)};
}

bool StatementParser::at_line_end() {
  while (tokens_.peek().is_symbol(";")) tokens_.take();
  return tokens_.peek().ends_line();
}

// A statement with what its output is redirected to.
StatementPointer StatementParser::listed() {
  return redirected(statement());
}

StatementPointer StatementParser::redirected(StatementPointer statement) {
  const Token& token = tokens_.peek();
  Redirected result;
  if (token.is_symbol(">>")) {
    result.kind = Redirection::append;
  } else if (token.is_symbol("|")) {
    result.kind = Redirection::pipe;
  } else if (!token.is_symbol(">>>") && !token.is_symbol(">")) {
    return statement;
  }
  const Token symbol = tokens_.take();
  result.target = expression();
  result.statement = std::move(statement);
  return make(std::move(result), symbol.place);
}

Block StatementParser::braces() {
  const Token opener = tokens_.take();
  const Brackets brackets(tokens_);
  const LocalNames names(scope_);
  Block block;
  while (true) {
    while (accept(";")) {
    }
    if (accept("}")) return block;
    const Token& token = tokens_.peek();
    if (token.is(TokenKind::end)) throw Incomplete(opener.place, "this \"{\" is never closed: missing \"}\"");
    if (token.is_symbol(")")) throw text::Error(token.place, "this \")\" closes nothing");
    block.statements.push_back(listed());
    const Token& after = tokens_.peek();
    const bool separated = after.is_symbol(";") || after.is_symbol("}") || after.is(TokenKind::end);
    if (!separated && !ends_with_brace(*block.statements.back())) {
      throw text::Error(after.place, fmt::format("expected \";\" or \"}}\", found {}", describe(after)),
                        "inside braces commands are separated by semicolons");
    }
  }
}

StatementPointer StatementParser::block_with_count() {
  const text::Place place = tokens_.peek().place;
  StatementPointer block = make(braces(), place);
  if (!tokens_.peek().is(TokenKind::number)) return block;
  return make(Repetition{std::move(block), expression()}, place);
}

// --- one statement

// The body of a loop or of a branch: it may stand on the next line.
StatementPointer StatementParser::inner() {
  skip_lines();
  if (tokens_.peek().is(TokenKind::end)) unexpected("a command");
  return statement();
}

StatementPointer StatementParser::statement() {
  const Level level(*this);
  const Token& token = tokens_.peek();
  if (token.is_symbol("{")) return block_with_count();
  if (token.is_symbol(";")) return make(Block{}, token.place);  // nothing to do, as in `while c do ;`
  if (token.is_symbol("++") || token.is_symbol("--")) {
    const Token symbol = tokens_.take();
    return step(expect_name("a variable"), symbol.place, symbol.text == "++");
  }
  if (token.is_symbol("}") || token.is_symbol(")")) {
    throw text::Error(token.place, fmt::format("this {} closes nothing", describe(token)));
  }
  if (!token.is(TokenKind::word)) {
    if (token.ends_line()) unexpected("a command");
    throw text::Error(token.place, fmt::format("expected a command, found {}", describe(token)),
                      "to see a value: print EXPRESSION; for all commands: help");
  }
  if (is_keyword(token.text)) return keyword_statement();
  return word_statement();
}

StatementPointer StatementParser::keyword_statement() {
  const Token& token = tokens_.peek();
  if (token.is_word("if")) return conditionally();
  if (token.is_word("while")) return while_loop();
  if (token.is_word("do")) return do_loop();
  if (token.is_word("for")) return for_loop();
  if (token.is_word("foreach")) return foreach_loop();
  if (token.is_word("break")) return leave(true);
  if (token.is_word("continue")) return leave(false);
  if (token.is_word("return")) return return_statement();
  if (token.is_word("local")) return local_declaration();
  if (token.is_word("procedure") || token.is_word("function")) return declared_procedure();
  if (token.is_word("else")) {
    throw text::Error(
        token.place, "this else belongs to no if",
        "at the prompt an else begins on the line on which its if ends; braces around both also do");
  }
  throw text::Error(token.place, fmt::format("a command cannot begin with {}", describe(token)));
}

StatementPointer StatementParser::word_statement() {
  // What follows may be a file's name, not made of tokens.
  tokens_.peek();
  const std::string_view after = tokens_.text_after_next();
  if (begins_assignment(after)) return assignment();
  if (after.starts_with("::=") || after.starts_with(":::=")) {
    const text::Place place = tokens_.peek(1).place;
    throw text::Error(place, "permanent definitions are not supported", "use :=");
  }
  if (expressions().at_elements()) return attribute_assignment();
  if (scope_.procedure(tokens_.peek().text)) return procedure_call();
  if (scope_.is_command(tokens_.peek().text)) {
    const text::Place place = tokens_.peek().place;
    return make(CommandStatement{scope_.parse_command(tokens_)}, place);
  }
  const Token word = tokens_.take();
  if (scope_.variable(word.text) || scope_.internal(word.text) ||
      scope_.locals().find(word.text) != nullptr) {
    throw text::Error(word.place, fmt::format("\"{}\" is a value, not a command", word.text),
                      fmt::format("print {} shows it", word.text));
  }
  std::vector<std::string> known;
  scope_.collect_statement_words(known);
  for (const std::string_view keyword : keywords) known.emplace_back(keyword);
  throw text::Error(word.place, fmt::format("there is no command \"{}\"", word.text),
                    text::did_you_mean(word.text, known));
}

// --- assignments

StatementPointer StatementParser::assignment() {
  const Token name = tokens_.take();
  if (tokens_.peek().is_symbol("++") || tokens_.peek().is_symbol("--")) {
    return step(name, name.place, tokens_.take().text == "++");
  }
  const bool plain = tokens_.peek().is_symbol(":=");
  if (plain && scope_.locals().find(name.text) == nullptr) {
    const std::uint32_t mark = tokens_.mark();
    tokens_.take();
    skip_lines();
    if (tokens_.peek().is_symbol("{") || value_is_command()) return procedure_definition(name);
    tokens_.rewind(mark);
  }
  return assign_name(name);
}

// Whether what follows `name :=` is a command, as in `gg := g 10`: its word means no value.
bool StatementParser::value_is_command() {
  const Token& token = tokens_.peek();
  if (!token.is(TokenKind::word) || !scope_.is_command(token.text)) return false;
  const bool value = scope_.variable(token.text) || scope_.internal(token.text) ||
                     scope_.locals().find(token.text) != nullptr || named_number(token.text);
  return !value && !tokens_.text_after_next().starts_with("(");
}

void StatementParser::check_new_name(const Token& name) {
  if (is_keyword(name.text) || element_kind(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is a word of the language", name.text),
                      "choose another name");
  }
}

StatementPointer StatementParser::assign_name(const Token& name) {
  if (const Local* const local = scope_.locals().find(name.text)) {
    if (local->element)
      throw text::Error(name.place, fmt::format("\"{}\" is an element, which cannot be replaced", name.text));
    return assign_to(local->id);
  }
  if (const auto internal = scope_.internal(name.text); internal && !scope_.variable(name.text))
    return assign_to(*internal);
  check_new_name(name);
  if (scope_.procedure(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is a procedure", name.text),
                      "choose another name for the value");
  }
  if (!tokens_.peek().is_symbol(":=") && !scope_.variable(name.text)) {
    throw text::Error(name.place, fmt::format("\"{}\" is not defined", name.text),
                      suggest_name(name.text, scope_));
  }
  // The value is parsed before the name exists: x := x + 1 needs an x from before.
  const text::Place place = tokens_.peek().place;
  Assignment result = assigned_value();
  result.target = scope_.promise_variable(name.text);
  return make(std::move(result), place);
}

// `:= value` and the like, the target still open.
Assignment StatementParser::assigned_value() {
  Assignment result;
  result.kind = *assignment_kind(tokens_.take());
  skip_lines();
  result.value = expression();
  return result;
}

StatementPointer StatementParser::assign_to(
    std::variant<VariableId, LocalId, InternalId, AttributeUse> target) {
  const text::Place place = tokens_.peek().place;
  Assignment result = assigned_value();
  result.target = std::move(target);
  return make(std::move(result), place);
}

// name++ or --name
StatementPointer StatementParser::step(const Token& name, const text::Place& place, bool up) {
  Assignment result;
  result.kind = up ? AssignmentKind::add : AssignmentKind::subtract;
  auto one = std::make_unique<Expression>();
  one->node = Number{1};
  one->place = place;
  result.value = std::move(one);
  if (const Local* const local = scope_.locals().find(name.text); local != nullptr && !local->element) {
    result.target = local->id;
  } else if (const auto variable = scope_.variable(name.text)) {
    result.target = *variable;
  } else if (const auto internal = scope_.internal(name.text)) {
    result.target = *internal;
  } else {
    throw text::Error(name.place, fmt::format("\"{}\" is not defined", name.text),
                      suggest_name(name.text, scope_));
  }
  return make(std::move(result), place);
}

StatementPointer StatementParser::attribute_assignment() {
  ExpressionParser parser = expressions();
  const Token first = tokens_.peek();
  if (!(tokens_.peek(1).is_symbol("[") || tokens_.peek(1).is_symbol("."))) {
    throw text::Error(first.place, fmt::format("a command cannot begin with {}", describe(first)),
                      fmt::format("write list {0}, print {0}.id or {0}.x := 1", first.text));
  }
  ElementPath path = parser.element();
  expect(".", "and an attribute");
  AttributeUse target = parser.attribute(std::move(path));
  if (!assignment_kind(tokens_.peek())) unexpected("\":=\"");
  return assign_to(std::move(target));
}

// --- procedures

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
  return make(std::move(result), name.place);
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
  return make(std::move(result), name.place);
}

StatementPointer StatementParser::procedure_call() {
  const Token name = tokens_.take();
  const std::size_t wanted = *scope_.procedure(name.text);
  ProcedureCall result{text::lower(name.text), {}};
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
  StatementPointer call = make(std::move(result), name.place);
  if (at_command_end(tokens_)) return call;
  return make(Repetition{std::move(call), expression()}, name.place);
}

// --- control

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
  return make(std::move(result), keyword.place);
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
  return make(std::move(result), keyword.place);
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
  return make(std::move(result), keyword.place);
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
  return make(std::move(result), keyword.place);
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
  return make(std::move(result), keyword.place);
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
  if (is_break) return make(Break{levels}, keyword.place);
  return make(Continue{levels}, keyword.place);
}

StatementPointer StatementParser::return_statement() {
  const Token keyword = tokens_.take();
  Return result;
  if (!at_command_end(tokens_)) result.value = expression();
  return make(std::move(result), keyword.place);
}

StatementPointer StatementParser::local_declaration() {
  const Token keyword = tokens_.take();
  LocalDeclaration result;
  do {
    const Token name = expect_name("a name");
    check_new_name(name);
    result.ids.push_back(scope_.locals().declare(name.text));
  } while (accept(","));
  return make(std::move(result), keyword.place);
}

}  // namespace lamella::language
