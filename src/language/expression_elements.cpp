// Elements and their attributes, as ExpressionParser takes them.
#include <fmt/format.h>

#include "language/expression_parser.h"
#include "text/suggest.h"

namespace lamella::language {

namespace {

std::string list_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 30;
  std::string result;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) result += (i > 0 ? ", " : "") + names[i];
  return result;
}

}  // namespace

// The element in turn under its own name, or where it has none, as what attributes are of.
ElementPath ExpressionParser::element_in_turn(const Local& local, const text::Place& place) const {
  ElementPath path;
  path.local = local.id;
  path.root_kind = *local.element;
  path.place = place;
  return path;
}

bool ExpressionParser::at_elements() {
  const Token& token = tokens_.peek();
  if (!token.is(TokenKind::word) || !scope_.has_elements()) return false;
  const Local* const local = scope_.locals().find(token.text);
  return (local != nullptr && local->element) || element_kind(token.text);
}

bool ExpressionParser::at_attribute() {
  const std::size_t end = path_end(0);
  return end > 0 && tokens_.peek(end).is_symbol(".");
}

ElementPath ExpressionParser::element() {
  if (!at_elements()) unexpected("an element such as vertex[3]");
  const Token first = tokens_.take();
  const Local* const local = scope_.locals().find(first.text);
  ElementPath path;
  path.place = first.place;
  if (local != nullptr && local->element) {
    path.local = local->id;
    path.root_kind = *local->element;
  } else {
    path.root_kind = *element_kind(first.text);
    if (!tokens_.peek().is_symbol("[")) {
      throw text::Error(first.place, fmt::format("which {}?", name_of(path.root_kind)),
                        fmt::format("name one by its number, as in {}[1]", name_of(path.root_kind)));
    }
    path.number = bracketed_index(path.place);
  }
  while (tokens_.peek().is_symbol(".") && element_kind(tokens_.peek(1).text) &&
         tokens_.peek(2).is_symbol("[")) {
    tokens_.take();
    const Token step = tokens_.take();
    path.place = join(path.place, step.place);
    ExpressionPointer index = bracketed_index(path.place);
    path.steps.push_back({*element_kind(step.text), std::move(index), step.place});
  }
  return path;
}

Generator ExpressionParser::generator(bool attribute_follows) {
  if (!at_elements()) unexpected("vertices, edges, facets or bodies");
  const Token first = tokens_.peek();
  Generator result;
  result.place = first.place;
  const Local* const local = scope_.locals().find(first.text);
  if ((local == nullptr || !local->element) && !tokens_.peek(1).is_symbol("[")) {
    result.kind = *element_kind(tokens_.take().text);
  } else {
    result.of = element();
    result.place = result.of->place;
    result.single = true;
    result.kind = result.of->kind();
    if (tokens_.peek().is_symbol(".") && element_kind(tokens_.peek(1).text)) {
      tokens_.take();
      const Token parts = tokens_.take();
      result.single = false;
      result.kind = *element_kind(parts.text);
      result.place = join(result.place, parts.place);
    }
  }
  std::string_view name;
  const Token& next = tokens_.peek();
  const bool reserved =
      next.is_word("where") || next.is_word("do") || next.is_word("and") || next.is_word("or");
  const Token& second = tokens_.peek(1);
  const bool named = second.is(TokenKind::word) && !second.is_word("where");
  const bool is_attribute =
      attribute_follows && (!named || scope_.attribute(result.kind, tokens_.peek().text));
  if (tokens_.peek().is(TokenKind::word) && !reserved && !is_attribute) name = tokens_.take().text;
  result.slot = scope_.locals().declare(name, result.kind);
  if (!attribute_follows) where_clause(result);
  return result;
}

void ExpressionParser::where_clause(Generator& generator) {
  if (!tokens_.peek().is_word("where")) return;
  tokens_.take();
  generator.where = expression();
}

// The place after the element path that begins `ahead` tokens on, or `ahead` if none does.
std::size_t ExpressionParser::path_end(std::size_t ahead) {
  const auto after_brackets = [&](std::size_t at) {
    int open = 0;
    do {
      const Token& token = tokens_.peek(at);
      if (token.is(TokenKind::end)) break;
      if (token.is_symbol("[")) ++open;
      if (token.is_symbol("]")) --open;
      ++at;
    } while (open > 0);
    return at;
  };
  const Token& first = tokens_.peek(ahead);
  if (!first.is(TokenKind::word) || !scope_.has_elements()) return ahead;
  const Local* const local = scope_.locals().find(first.text);
  const bool named = local != nullptr && local->element;
  if (!named && !element_kind(first.text)) return ahead;
  std::size_t at = ahead + 1;
  if (!named && tokens_.peek(at).is_symbol("[")) at = after_brackets(at);
  while (tokens_.peek(at).is_symbol(".") && element_kind(tokens_.peek(at + 1).text)) {
    at += 2;
    if (tokens_.peek(at).is_symbol("[")) at = after_brackets(at);
  }
  return at;
}

ExpressionPointer ExpressionParser::following_number(AttributeId attribute, text::Place& place) {
  const Token& token = tokens_.peek();
  if (token.is_symbol("[")) return bracketed_index(place);
  const std::optional<int> named =
      token.is(TokenKind::word) ? scope_.number_named(attribute, token.text) : std::nullopt;
  ExpressionPointer number;
  if (named) {
    const Token name = tokens_.take();
    auto made = std::make_unique<Expression>();
    made->place = name.place;
    made->node = Number{static_cast<double>(*named)};
    number = std::move(made);
  } else {
    number = primary();
  }
  place = join(place, number->place);
  return number;
}

AttributeUse ExpressionParser::attribute(ElementPath of) {
  const ElementKind kind = of.kind();
  if (!tokens_.peek().is(TokenKind::word)) unexpected(fmt::format("an attribute of {}", plural_of(kind)));
  const Token name = tokens_.take();
  const auto meaning = scope_.attribute(kind, name.text);
  if (!meaning) {
    std::vector<std::string> known;
    scope_.collect_attributes(kind, known);
    const std::string near = text::did_you_mean(name.text, known);
    throw text::Error(name.place, fmt::format("{} have no attribute \"{}\"", plural_of(kind), name.text),
                      near.empty() ? fmt::format("they have {}", list_names(known)) : near);
  }
  AttributeUse use{std::move(of), meaning->id, meaning->shape, {}};
  use.element.place = join(use.element.place, name.place);
  if (meaning->takes_number) use.indices.push_back(following_number(meaning->id, use.element.place));
  while (tokens_.peek().is_symbol("[") && use.indices.size() < use.shape.size())
    use.indices.push_back(bracketed_index(use.element.place));
  if (tokens_.peek().is_symbol("[")) {
    const std::string_view dimensions = use.shape.empty() ? "is a single number" : "has fewer dimensions";
    throw text::Error(tokens_.peek().place, fmt::format("\"{}\" {}", name.text, dimensions));
  }
  return use;
}

}  // namespace lamella::language
