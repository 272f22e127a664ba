#include "language/statement_parser.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "language/functions.h"
#include "language/letters.h"
#include "text/suggest.h"

namespace lamella::language {

namespace {

constexpr int deepest = 200;

constexpr std::array<std::string_view, 14> keywords = {"if",    "then",      "else",     "while",    "do",
                                                       "for",   "foreach",   "break",    "continue", "return",
                                                       "local", "procedure", "function", "where"};

// Whether the text behind a word makes an assignment of it. `show --x` is none: there a step ends the
// statement.
bool begins_assignment(std::string_view after) {
  for (const std::string_view symbol : {":=", "+=", "-=", "*=", "/=", "::=", ":::="}) {
    if (after.starts_with(symbol)) return true;
  }
  if (!after.starts_with("++") && !after.starts_with("--")) return false;
  const std::size_t next = after.find_first_not_of(" \t", 2);
  return next == std::string_view::npos ||
         std::string_view(";})\r\n/").find(after[next]) != std::string_view::npos;
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

bool is_keyword(std::string_view word) {
  const std::string key = text::lower(word);
  return std::find(keywords.begin(), keywords.end(), key) != keywords.end();
}

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
  return make_statement(std::move(result), symbol.place);
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
  StatementPointer block = make_statement(braces(), place);
  if (!tokens_.peek().is(TokenKind::number)) return block;
  return make_statement(Repetition{std::move(block), expression()}, place);
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
  if (token.is_symbol(";"))
    return make_statement(Block{}, token.place);  // nothing to do, as in `while c do ;`
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
  if (is_redefined_letter()) return procedure_call();
  const bool dotted = tokens_.peek(1).is_symbol(".") && !scope_.is_command(tokens_.peek().text);
  if (expressions().at_elements() || dotted) return attribute_assignment();
  if (after.starts_with("[") && scope_.variable(tokens_.peek().text)) return array_assignment();
  if (scope_.procedure(tokens_.peek().text)) return procedure_call();
  if (at_named_setting()) return named_setting();
  if (at_global_definition()) return refused("constraints, boundaries and quantities stand in the datafile");
  if (scope_.is_command(tokens_.peek().text)) {
    const text::Place place = tokens_.peek().place;
    return make_statement(CommandStatement{scope_.parse_command(tokens_)}, place);
  }
  if (scope_.user_function(tokens_.peek().text)) {
    const text::Place place = tokens_.peek().place;
    return make_statement(ExpressionStatement{expression()}, place);
  }
  if (const std::string reason = scope_.why_refused(tokens_.peek().text); !reason.empty())
    return refused(reason);
  if (is_letter_with_count(tokens_.peek())) return letter_with_count();
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

bool StatementParser::is_redefined_letter() {
  const Token& word = tokens_.peek();
  return word.text.size() == 1 && word.content.empty() && scope_.procedure(letter_name(word.text));
}

// The command goes on to where any would end.
StatementPointer StatementParser::refused(std::string_view reason) {
  const Token word = tokens_.take();
  int open = 0;
  while (open > 0 || !at_command_end(tokens_)) {
    const Token token = tokens_.take();
    if (token.is(TokenKind::end)) throw Incomplete(token.place, "a bracket is never closed");
    if (token.is_symbol("(") || token.is_symbol("[") || token.is_symbol("{")) ++open;
    if (token.is_symbol(")") || token.is_symbol("]") || token.is_symbol("}")) --open;
  }
  return make_statement(RefusedCommand{fmt::format("{} is not supported: {}", word.text, reason)},
                        word.place);
}

bool StatementParser::at_global_definition() {
  if (!tokens_.peek().is_word("define")) return false;
  const Token& what = tokens_.peek(1);
  return what.is_word("constraint") || what.is_word("boundary") || what.is_word("quantity") ||
         what.is_word("method_instance");
}

// `g5` is g 5, though `g` and the number stick together.
bool StatementParser::is_letter_with_count(const Token& word) const {
  const std::string_view digits = word.text.substr(1);
  const bool number = !digits.empty() && digits.size() < 9 &&
                      digits.find_first_not_of("0123456789") == std::string_view::npos;
  return number && scope_.is_command(word.text.substr(0, 1));
}

StatementPointer StatementParser::letter_with_count() {
  const Token word = tokens_.take();
  auto count = std::make_unique<Expression>();
  count->node = Number{std::stod(std::string(word.text.substr(1)))};
  count->place = word.place;
  const text::Place letter{word.place.source, word.place.offset, 1};
  LexerStream alone(Lexer(letter, LexerMode::command));
  StatementPointer command = make_statement(CommandStatement{scope_.parse_command(alone)}, word.place);
  return make_statement(Repetition{std::move(command), std::move(count)}, word.place);
}

}  // namespace lamella::language
