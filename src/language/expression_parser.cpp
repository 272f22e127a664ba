#include "language/expression_parser.h"

#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "language/functions.h"
#include "text/suggest.h"

namespace lamella::language {

namespace {

// Deeper trees would only serve to exhaust the stack.
constexpr int deepest = 200;

constexpr int rank_equate = 1;
constexpr int rank_conditional = 2;
constexpr int rank_or = 3;
constexpr int rank_and = 4;
constexpr int rank_comparison = 6;
constexpr int rank_sum = 7;
constexpr int rank_product = 8;
constexpr int rank_power = 10;

struct BinarySymbol {
  std::string_view text;
  int rank;
  BinaryOperator operation;
};

constexpr std::array<BinarySymbol, 21> binary_symbols = {{
    {"=", rank_equate, BinaryOperator::equate},
    {"||", rank_or, BinaryOperator::logical_or},
    {"or", rank_or, BinaryOperator::logical_or},
    {"&&", rank_and, BinaryOperator::logical_and},
    {"and", rank_and, BinaryOperator::logical_and},
    {"==", rank_comparison, BinaryOperator::equal},
    {"!=", rank_comparison, BinaryOperator::not_equal},
    {"<", rank_comparison, BinaryOperator::less},
    {">", rank_comparison, BinaryOperator::greater},
    {"<=", rank_comparison, BinaryOperator::less_equal},
    {">=", rank_comparison, BinaryOperator::greater_equal},
    {"+", rank_sum, BinaryOperator::add},
    {"-", rank_sum, BinaryOperator::subtract},
    {"*", rank_product, BinaryOperator::multiply},
    {"/", rank_product, BinaryOperator::divide},
    {"%", rank_product, BinaryOperator::modulus},
    {"mod", rank_product, BinaryOperator::modulus},
    {"imod", rank_product, BinaryOperator::integer_modulus},
    {"idiv", rank_product, BinaryOperator::integer_divide},
    {"^", rank_power, BinaryOperator::power},
    {"**", rank_power, BinaryOperator::power},
}};

constexpr std::array<std::pair<std::string_view, AggregateKind>, 5> aggregates = {
    {{"sum", AggregateKind::sum},
     {"min", AggregateKind::minimum},
     {"max", AggregateKind::maximum},
     {"avg", AggregateKind::average},
     {"count", AggregateKind::count}}};

constexpr std::array<std::string_view, 4> special_calls = {"sprintf", "is_defined", "sizeof",
                                                           "valid_element"};

template <class Node>
ExpressionPointer make(Node node, text::Place place) {
  auto result = std::make_unique<Expression>();
  result->node = std::move(node);
  result->place = std::move(place);
  return result;
}

std::optional<AggregateKind> aggregate_kind(const Token& token) {
  for (const auto& [name, kind] : aggregates) {
    if (token.is_word(name)) return kind;
  }
  return std::nullopt;
}

bool is_special_call(const Token& token) {
  for (const std::string_view name : special_calls) {
    if (token.is_word(name)) return true;
  }
  return false;
}

}  // namespace

// Counts how deep the tree is while one of its levels is parsed.
class ExpressionParser::Level {
 public:
  explicit Level(ExpressionParser& parser) : parser_(parser) {
    if (++parser_.depth_ <= deepest) return;
    --parser_.depth_;
    throw text::Error(parser_.tokens_.peek().place,
                      fmt::format("this expression is nested more than {} levels deep", deepest),
                      "give parts of it names");
  }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;
  ~Level() { --parser_.depth_; }

 private:
  ExpressionParser& parser_;
};

// What stands between brackets, which it is told of.
class ExpressionParser::Enclosed {
 public:
  explicit Enclosed(ExpressionParser& parser) : parser_(parser), lines_(parser.tokens_) {
    ++parser_.brackets_;
  }
  Enclosed(const Enclosed&) = delete;
  Enclosed& operator=(const Enclosed&) = delete;
  ~Enclosed() { --parser_.brackets_; }

 private:
  ExpressionParser& parser_;
  Brackets lines_;
};

// --- tokens

bool ExpressionParser::accept(std::string_view symbol) {
  if (!tokens_.peek().is_symbol(symbol)) return false;
  tokens_.take();
  return true;
}

// In a datafile a comma is white space that the next token remembers.
bool ExpressionParser::accept_comma() {
  if (in_command()) return accept(",");
  return tokens_.peek().separator == ',';
}

void ExpressionParser::unexpected(std::string_view wanted, std::string_view after) {
  const Token& found = tokens_.peek();
  const std::string where = after.empty() ? std::string{} : fmt::format(" after \"{}\"", after);
  const std::string message = fmt::format("expected {}{}, found {}", wanted, where, describe(found));
  if (found.is(TokenKind::end) && in_command()) throw Incomplete(found.place, message);
  throw text::Error(found.place, message);
}

// Returns the place of the closing symbol.
text::Place ExpressionParser::close(std::string_view symbol, const Token& opener) {
  if (tokens_.peek().is_symbol(symbol)) return tokens_.take().place;
  const Token& found = tokens_.peek();
  if (found.ends_line()) {
    const std::string message =
        fmt::format("this \"{}\" is never closed: missing \"{}\"", opener.text, symbol);
    if (found.is(TokenKind::end) && in_command()) throw Incomplete(opener.place, message);
    throw text::Error(opener.place, message);
  }
  text::Diagnostic diagnostic{text::Severity::error,
                              found.place,
                              fmt::format("expected \"{}\", found {}", symbol, describe(found)),
                              {},
                              {}};
  diagnostic.notes.push_back({opener.place, fmt::format("to close this \"{}\"", opener.text)});
  throw text::Error(std::move(diagnostic));
}

// --- operators

ExpressionPointer ExpressionParser::expression() {
  return ranked(rank_equate);
}

std::optional<ExpressionParser::Operator> ExpressionParser::binary_operator() {
  const Token& token = tokens_.peek();
  if (token.separator != 0) return std::nullopt;
  if (token.is_symbol("?")) return Operator{rank_conditional, BinaryOperator::add, true};
  for (const BinarySymbol& symbol : binary_symbols) {
    if (!token.is_symbol(symbol.text) && !token.is_word(symbol.text)) continue;
    const bool open = brackets_ == 0;
    const bool values_follow = style_ == ExpressionStyle::values || style_ == ExpressionStyle::argument;
    const bool signs_next_value =
        values_follow && open && token.is_symbol("-") && token.space_before && !tokens_.peek(1).space_before;
    const bool redirects = in_command() && style_ != ExpressionStyle::condition && open &&
                           token.is_symbol(">") && tokens_.peek(1).is(TokenKind::string);
    if (signs_next_value || redirects) return std::nullopt;
    return Operator{symbol.rank, symbol.operation, false};
  }
  return std::nullopt;
}

// Operators of at least this rank. Neighbours of one rank become one chain.
ExpressionPointer ExpressionParser::ranked(int lowest) {
  const Level level(*this);
  ExpressionPointer left = prefix();
  Chain chain;
  int chain_rank = 0;
  const auto close_chain = [&] {
    if (!chain.first) return;
    text::Place place = join(chain.first->place, chain.links.back().operand->place);
    left = make(std::exchange(chain, {}), std::move(place));
  };
  for (std::optional<Operator> next = binary_operator(); next && next->rank >= lowest;
       next = binary_operator()) {
    if (next->rank != chain_rank) close_chain();
    if (next->conditional) {
      left = conditional(std::move(left));
      continue;
    }
    const Token symbol = tokens_.take();
    waiting_operator_ = symbol.text;
    // Comparisons group from the right, everything else from the left.
    const bool comparison = next->rank == rank_comparison;
    ExpressionPointer right = ranked(comparison ? next->rank : next->rank + 1);
    if (comparison) {
      text::Place place = join(left->place, right->place);
      left = make(Comparison{next->operation, std::move(left), std::move(right)}, std::move(place));
      continue;
    }
    if (!chain.first) chain.first = std::move(left);
    chain_rank = next->rank;
    chain.links.push_back({next->operation, std::move(right), symbol.place});
  }
  close_chain();
  return left;
}

ExpressionPointer ExpressionParser::conditional(ExpressionPointer condition) {
  const Token question = tokens_.take();
  ExpressionPointer yes = ranked(rank_conditional);
  const bool colon = in_command() ? accept(":") : tokens_.peek().separator == ':';
  if (!colon) unexpected("\":\" and a second value", "?");
  ExpressionPointer no = ranked(rank_conditional);
  text::Place place = join(condition->place, no->place);
  return make(Conditional{std::move(condition), std::move(yes), std::move(no)}, std::move(place));
}

ExpressionPointer ExpressionParser::prefix() {
  const Token& token = tokens_.peek();
  const bool negative = token.is_symbol("-");
  const bool inverted = token.is_symbol("!") || token.is_word("not");
  if (!negative && !inverted && !token.is_symbol("+")) return primary();
  const Level level(*this);
  const Token sign = tokens_.take();
  ExpressionPointer operand = ranked(inverted ? rank_comparison : rank_power);
  if (!negative && !inverted) return operand;
  text::Place place = join(sign.place, operand->place);
  const UnaryOperator operation = negative ? UnaryOperator::negate : UnaryOperator::logical_not;
  return make(Unary{operation, std::move(operand)}, std::move(place));
}

// --- operands

ExpressionPointer ExpressionParser::primary() {
  const std::string_view after = std::exchange(waiting_operator_, {});
  // An operand is due: commands and formulas go on on the next line.
  const bool goes_on = in_command() || style_ == ExpressionStyle::formula;
  while (goes_on && tokens_.peek().is(TokenKind::newline)) {
    tokens_.take();
  }
  const Token& token = tokens_.peek();
  switch (token.kind) {
    case TokenKind::number: {
      const Token number = tokens_.take();
      return make(Number{number.number}, number.place);
    }
    case TokenKind::string:
      return string();
    case TokenKind::word:
      return word();
    default:
      break;
  }
  if (token.is_symbol("(")) return parentheses();
  unexpected("a value", after);
}

ExpressionPointer ExpressionParser::parentheses() {
  const Token opener = tokens_.take();
  const Enclosed enclosed(*this);
  ExpressionPointer inside = expression();
  close(")", opener);
  return inside;
}

// Neighbouring strings are one.
ExpressionPointer ExpressionParser::string() {
  const Token first = tokens_.take();
  std::string content = first.content;
  text::Place place = first.place;
  while (tokens_.peek().is(TokenKind::string)) {
    const Token next = tokens_.take();
    content += next.content;
    place = join(place, next.place);
  }
  return make(Text{std::move(content)}, std::move(place));
}

ExpressionPointer ExpressionParser::word() {
  const bool called = tokens_.peek(1).is_symbol("(") && tokens_.peek(1).separator == 0;
  if (called && aggregate_ahead()) return aggregate(*aggregate_kind(tokens_.peek()));
  if (is_special_call(tokens_.peek())) return special_call();
  if (ExpressionPointer local = local_or_attribute()) return local;
  if (scope_.has_elements() && element_kind(tokens_.peek().text)) return attribute_of_element();

  const std::string_view name = tokens_.peek().text;
  const Function* const function = find_function(name);
  const auto arity = scope_.user_function(name);
  if (called && arity) return user_call(*arity);
  if (called && function != nullptr) return call(*function);
  text::Place place;
  if (const auto id = dotted_internal(place)) return make(InternalUse{*id}, place);
  if (const auto id = dotted_variable(place)) return make(VariableUse{*id}, place);
  refuse_unknown_part();
  if (const auto id = scope_.variable(name)) return variable(*id);
  if (arity && arity->most == 0) return user_call(*arity);
  if (const auto id = scope_.internal(name)) return make(InternalUse{*id}, tokens_.take().place);
  if (const auto value = named_number(name)) return make(Number{*value}, tokens_.take().place);
  if (function != nullptr) {
    const Token token = tokens_.take();
    throw text::Error(token.place, fmt::format("\"{}\" needs its argument in parentheses: {}(...)",
                                               token.text, token.text));
  }
  unknown_name(tokens_.take());
}

// Two words with a dot between them; empty if that is not what comes.
std::string ExpressionParser::dotted_name() {
  const Token& name = tokens_.peek();
  if (!name.is(TokenKind::word) || scope_.locals().find(name.text) != nullptr) return {};
  std::string first(name.text);
  if (!tokens_.peek(1).is_symbol(".") || !tokens_.peek(2).is(TokenKind::word)) return {};
  return std::move(first) + "." + std::string(tokens_.peek(2).text);
}

text::Place ExpressionParser::take_dotted() {
  const text::Place begin = tokens_.take().place;
  tokens_.take();
  return join(begin, tokens_.take().place);
}

std::optional<InternalId> ExpressionParser::dotted_internal(text::Place& place) {
  const std::string name = dotted_name();
  const auto id = name.empty() ? std::nullopt : scope_.internal(name);
  if (id) place = take_dotted();
  return id;
}

std::optional<VariableId> ExpressionParser::dotted_variable(text::Place& place) {
  const std::string name = dotted_name();
  const auto id = name.empty() ? std::nullopt : scope_.variable(name);
  if (id) place = take_dotted();
  return id;
}

// A local name, or an attribute of the element in turn, whichever is the nearer; null if the next word is
// neither.
ExpressionPointer ExpressionParser::local_or_attribute() {
  const std::string_view name = tokens_.peek().text;
  const Local* const local = scope_.locals().find(name);
  const Local* const in_turn = scope_.locals().element_in_turn();
  const bool attribute_is_nearer =
      in_turn != nullptr && (local == nullptr || local->id.slot < in_turn->id.slot);
  if (attribute_is_nearer && scope_.attribute(*in_turn->element, name)) {
    const text::Place place = tokens_.peek().place;
    return make(attribute(element_in_turn(*in_turn, place)), place);
  }
  if (local == nullptr) return nullptr;
  if (local->element) return attribute_of_element();
  return make(LocalUse{local->id}, tokens_.take().place);
}

ExpressionPointer ExpressionParser::attribute_of_element() {
  ElementPath path = element();
  if (!accept(".") && !tokens_.peek().is(TokenKind::word)) {
    const std::string written = path.place.source->content.substr(path.place.offset, path.place.length);
    const std::string example = fmt::format("write {}.{} for an attribute", written,
                                            path.kind() == ElementKind::body ? "volume" : "id");
    throw text::Error(path.place, "an element is no value", example);
  }
  AttributeUse use = attribute(std::move(path));
  text::Place place = use.element.place;
  return make(std::move(use), std::move(place));
}

// Parses `[index]`; `place` grows to its end.
ExpressionPointer ExpressionParser::bracketed_index(text::Place& place) {
  const Token opener = tokens_.take();
  const Enclosed enclosed(*this);
  ExpressionPointer index = expression();
  place = join(place, close("]", opener));
  return index;
}

// Whether `max(` and the like goes on with elements, as in max(edge, length), not with values, as in
// max(edge[1].length, 2).
bool ExpressionParser::aggregate_ahead() {
  const auto kind = aggregate_kind(tokens_.peek());
  if (!kind) return false;
  const std::size_t end = path_end(2);
  if (end == 2) return *kind != AggregateKind::minimum && *kind != AggregateKind::maximum;
  return !tokens_.peek(end).is_symbol(".");
}

// --- calls

std::vector<ExpressionPointer> ExpressionParser::arguments(const Token& name,
                                                           std::optional<std::size_t> wanted) {
  const Token opener = tokens_.take();
  const Enclosed enclosed(*this);
  std::vector<ExpressionPointer> result;
  if (!tokens_.peek().is_symbol(")")) {
    do {
      result.push_back(expression());
    } while (accept_comma());
  }
  close(")", opener);
  if (wanted && result.size() != *wanted) {
    throw text::Error(name.place, fmt::format("{} takes {} argument{}, not {}", name.text, *wanted,
                                              *wanted == 1 ? "" : "s", result.size()));
  }
  return result;
}

ExpressionPointer ExpressionParser::call(const Function& function) {
  const Token name = tokens_.take();
  return make(Call{&function, arguments(name, function.arguments)}, name.place);
}

ExpressionPointer ExpressionParser::user_call(const Arity& arity) {
  const Token name = tokens_.take();
  UserCall result{text::lower(name.text), {}};
  if (tokens_.peek().is_symbol("("))
    result.arguments = arguments(name, arity.least == arity.most ? std::optional(arity.least) : std::nullopt);
  if (result.arguments.size() < arity.least || result.arguments.size() > arity.most) {
    throw text::Error(name.place, fmt::format("{} takes at least {} arguments, not {}", name.text,
                                              arity.least, result.arguments.size()));
  }
  return make(std::move(result), name.place);
}

ExpressionPointer ExpressionParser::variable(VariableId id) {
  text::Place place = tokens_.take().place;
  if (!tokens_.peek().is_symbol("[") || tokens_.peek().separator != 0) return make(VariableUse{id}, place);
  ArrayUse use{id, array_indices(place)};
  return make(std::move(use), place);
}

ExpressionPointer ExpressionParser::array_literal() {
  const Level level(*this);
  const Token opener = tokens_.take();
  const Enclosed enclosed(*this);
  ArrayLiteral result;
  do {
    result.items.push_back(tokens_.peek().is_symbol("{") ? array_literal() : expression());
  } while (accept_comma());
  text::Place place = join(opener.place, close("}", opener));
  return make(std::move(result), std::move(place));
}

std::vector<ExpressionPointer> ExpressionParser::array_indices(text::Place& place) {
  std::vector<ExpressionPointer> indices;
  while (tokens_.peek().is_symbol("[")) indices.push_back(bracketed_index(place));
  return indices;
}

ExpressionPointer ExpressionParser::aggregate(AggregateKind kind) {
  const Token name = tokens_.take();
  const Token opener = tokens_.take();
  const Enclosed enclosed(*this);
  const LocalNames names(scope_);
  Aggregate result{kind, generator(), nullptr};
  const bool comma = accept_comma();
  if (comma) result.value = expression();
  if (!comma && kind != AggregateKind::count) unexpected("a comma and what to take of each element");
  close(")", opener);
  return make(std::move(result), name.place);
}

ExpressionPointer ExpressionParser::special_call() {
  const Token name = tokens_.take();
  if (name.is_word("sprintf")) {
    const bool bracketed = tokens_.peek().is_symbol("(");
    std::vector<ExpressionPointer> given;
    if (bracketed) {
      given = arguments(name, std::nullopt);
    } else {
      do {
        given.push_back(expression());
      } while (accept_comma());
    }
    if (given.empty()) unexpected("a format string", "sprintf");
    Format format{std::move(given.front()), {}};
    given.erase(given.begin());
    format.arguments = std::move(given);
    return make(std::move(format), name.place);
  }
  if (!tokens_.peek().is_symbol("(")) unexpected("\"(\"", name.text);
  if (name.is_word("valid_element")) {
    const Token opener = tokens_.take();
    const Enclosed enclosed(*this);
    ElementPath path = element();
    close(")", opener);
    return make(ValidElement{std::move(path)}, name.place);
  }
  std::vector<ExpressionPointer> given = arguments(name, 1);
  if (name.is_word("sizeof")) return make(SizeOf{std::move(given.front())}, name.place);
  return make(IsDefined{std::move(given.front())}, name.place);
}

// --- names that are not known

void ExpressionParser::unknown_name(const Token& name) {
  const bool called = tokens_.peek().is_symbol("(") && !tokens_.peek().space_before;
  const std::string message = called ? fmt::format("there is no function \"{}\"", name.text)
                                     : fmt::format("\"{}\" is not defined", name.text);
  throw text::Error(name.place, message, suggest_name(name.text, scope_));
}

void ExpressionParser::refuse_unknown_part() {
  const std::string name = dotted_name();
  if (name.empty()) return;
  std::vector<std::string> parts;
  scope_.collect_parts(tokens_.peek().text, parts);
  if (parts.empty()) return;
  std::string hint = text::did_you_mean(name, parts);
  if (hint.empty()) hint = fmt::format("there are {}", fmt::join(parts, ", "));
  throw text::Error(take_dotted(), fmt::format("\"{}\" is not defined", name), hint);
}

std::string suggest_name(std::string_view name, const Scope& scope) {
  std::vector<std::string> known;
  scope.collect_names(known);
  for (const Local& local : scope.locals().names()) known.push_back(local.name);
  if (const Local* const in_turn = scope.locals().element_in_turn())
    scope.collect_attributes(*in_turn->element, known);
  for (const Function& function : functions()) known.emplace_back(function.name);
  for (const NamedNumber& number : named_numbers()) known.emplace_back(number.name);
  return text::did_you_mean(name, known);
}

}  // namespace lamella::language
