#include "session/argument_parser.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "language/formula_scope.h"
#include "language/functions.h"
#include "session/names.h"
#include "text/suggest.h"

namespace lamella::session {

using language::ExpressionParser;
using language::ExpressionStyle;
using language::LexerStream;
using language::Token;
using language::TokenKind;

namespace {

class ArgumentParser {
 public:
  ArgumentParser(const Command& command, LexerStream& tokens, Names& names)
      : command_(command), tokens_(tokens), names_(names) {}

  std::unique_ptr<const Invocation> run() {
    word_ = tokens_.take();
    auto call = std::make_unique<Invocation>();
    call->command = &command_;
    result_ = call.get();
    while (bare() || (!language::at_command_end(tokens_) && (named() || positional() || refuse()))) {
    }
    for (const Argument& argument : command_.arguments) {
      if (argument.needed && !given(argument)) {
        throw text::Error(word_.place, fmt::format("{} needs {}", word_.text, described(argument)),
                          "usage: " + usage(command_));
      }
    }
    return call;
  }

 private:
  ExpressionParser expressions() { return {tokens_, names_, ExpressionStyle::command}; }

  static std::string described(const Argument& argument) {
    return argument.help.empty() ? argument.name : fmt::format("{} ({})", argument.name, argument.help);
  }

  bool given(const Argument& argument) const {
    return std::any_of(result_->arguments.begin(), result_->arguments.end(),
                       [&](const TypedArgument& typed) { return typed.argument == &argument; });
  }

  // A file's name or a word that need not be made of tokens, if that is what comes next.
  bool bare() {
    const Argument* const argument = next_positional();
    const bool takes_bare =
        argument != nullptr && (argument->kind == ArgumentKind::file || argument->kind == ArgumentKind::word);
    if (!takes_bare) return false;
    const std::string_view ahead = tokens_.bare_word_ahead();
    const bool quoted = tokens_.text_ahead().starts_with('"');
    if ((ahead.empty() && !quoted) || is_option(ahead)) return false;
    result_->arguments.push_back(value(*argument, word_.place));
    return true;
  }

  const Argument* next_positional() const {
    for (const Argument& argument : command_.arguments) {
      if (!argument.named && !given(argument)) return &argument;
    }
    return nullptr;
  }

  bool is_option(std::string_view word) const {
    const std::string key = text::lower(word.substr(0, word.find('=')));
    return std::any_of(command_.arguments.begin(), command_.arguments.end(),
                       [&](const Argument& argument) { return argument.named && argument.name == key; });
  }

  // An option by its name: `dt 0.01`, `dt=0.01`, or a flag.
  bool named() {
    const Token& token = tokens_.peek();
    if (!token.is(TokenKind::word)) return false;
    for (const Argument& argument : command_.arguments) {
      if (!argument.named || !token.is_word(argument.name)) continue;
      if (given(argument)) throw text::Error(token.place, fmt::format("{} is given twice", argument.name));
      const Token name = tokens_.take();
      if (tokens_.peek().is_symbol("=")) tokens_.take();
      if (argument.kind != ArgumentKind::flag && value_is_missing(argument)) {
        throw text::Error(name.place, fmt::format("{} needs its value", name.text),
                          "usage: " + usage(command_));
      }
      result_->arguments.push_back(value(argument, name.place));
      return true;
    }
    return false;
  }

  // A bare word need not be made of tokens.
  bool value_is_missing(const Argument& argument) {
    const bool bare_word = argument.kind == ArgumentKind::file || argument.kind == ArgumentKind::word;
    if (bare_word && !tokens_.bare_word_ahead().empty()) return false;
    return language::at_command_end(tokens_);
  }

  // The next positional argument that what follows can be.
  bool positional() {
    for (const Argument& argument : command_.arguments) {
      if (argument.named || given(argument)) continue;
      if (fits(argument)) {
        const text::Place place = tokens_.peek().place;
        result_->arguments.push_back(value(argument, place));
        return true;
      }
      if (argument.needed) return false;
    }
    return false;
  }

  bool is_known_name(std::string_view word) const {
    return names_.variable(word) || names_.internal(word) || names_.locals().find(word) != nullptr;
  }
  bool is_known_value(const Token& token) const { return is_known_name(token.text); }

  // Whether the next token can begin such an argument; a word that means nothing is better refused as an
  // unknown option.
  bool fits(const Argument& argument) {
    const Token& token = tokens_.peek();
    const bool elements = expressions().at_elements();
    switch (argument.kind) {
      case ArgumentKind::elements:
      case ArgumentKind::selection:
      case ArgumentKind::setting:
        return elements;
      case ArgumentKind::word:
      case ArgumentKind::file:
        return true;
      case ArgumentKind::definition:
      case ArgumentKind::expressions:
      case ArgumentKind::printable:
      case ArgumentKind::field:
        return true;
      case ArgumentKind::commands:
        return token.is_symbol("{");
      case ArgumentKind::sample:
        return token.is_symbol("(");
      case ArgumentKind::text:
        if (!argument.choices.empty()) return is_choice(argument, token);
        break;
      case ArgumentKind::number:
      case ArgumentKind::count:
        if (!argument.word_for_none.empty() && token.is_word(argument.word_for_none)) return true;
        if (elements) return expressions().at_attribute();
        if (token.is(TokenKind::string) && !argument.needed) return false;
        break;
      default:
        break;
    }
    if (!token.is(TokenKind::word)) return !token.is_symbol("=") && !token.is_symbol(",");
    return elements || begins_value(token);
  }

  // A word that means nothing is better refused as an unknown option than as an unknown value.
  bool begins_value(const Token& token) {
    const language::Local* const in_turn = names_.locals().element_in_turn();
    const bool attribute = in_turn != nullptr && names_.attribute(*in_turn->element, token.text);
    return attribute || is_known_value(token) || language::named_number(token.text) || token.is_word("not") ||
           token.is_word("sprintf") || tokens_.peek(1).is_symbol("(");
  }

  static bool is_choice(const Argument& argument, const Token& token) {
    return token.is(TokenKind::word) && std::find(argument.choices.begin(), argument.choices.end(),
                                                  text::lower(token.text)) != argument.choices.end();
  }

  [[noreturn]] bool refuse() {
    const Token& token = tokens_.peek();
    std::vector<std::string> known;
    for (const Argument& argument : command_.arguments) {
      if (argument.named) known.push_back(argument.name);
      known.insert(known.end(), argument.choices.begin(), argument.choices.end());
    }
    names_.collect_names(known);
    const std::string near =
        token.is(TokenKind::word) ? text::did_you_mean(token.text, known) : std::string{};
    const std::string message =
        command_.arguments.empty()
            ? fmt::format("{} takes no arguments, found {}", word_.text, describe(token))
            : fmt::format("{} does not take {} here", word_.text, describe(token));
    const bool more = std::any_of(command_.arguments.begin(), command_.arguments.end(),
                                  [&](const Argument& a) { return !given(a); });
    const std::string hint =
        more ? "usage: " + usage(command_) : "commands on one line are separated by semicolons";
    throw text::Error(token.place, message, near.empty() ? hint : near);
  }

  TypedArgument value(const Argument& argument, const text::Place& place) {
    TypedArgument typed;
    typed.argument = &argument;
    typed.place = place;
    switch (argument.kind) {
      case ArgumentKind::flag:
        break;
      case ArgumentKind::number:
      case ArgumentKind::count:
      case ArgumentKind::text:
        simple(typed);
        break;
      case ArgumentKind::file:
        file(typed);
        break;
      case ArgumentKind::word:
        bare_word(typed);
        break;
      case ArgumentKind::numbers:
        numbers(typed);
        break;
      case ArgumentKind::elements:
      case ArgumentKind::selection:
        generator(typed);
        break;
      case ArgumentKind::expressions:
        list(typed);
        break;
      case ArgumentKind::setting:
        setting(typed);
        break;
      case ArgumentKind::definition:
        definition(typed);
        break;
      case ArgumentKind::printable:
        printable(typed);
        break;
      case ArgumentKind::field:
        field(typed);
        break;
      case ArgumentKind::commands:
        commands(typed);
        break;
      case ArgumentKind::formulas:
        formulas(typed);
        break;
      case ArgumentKind::sample:
        sample(typed);
        break;
    }
    return typed;
  }

  void simple(TypedArgument& typed) {
    const Token& token = tokens_.peek();
    const Argument& argument = *typed.argument;
    if (!argument.word_for_none.empty() && token.is_word(argument.word_for_none)) {
      typed.word = text::lower(tokens_.take().text);
      return;
    }
    if (!argument.choices.empty()) {
      if (!is_choice(argument, token)) {
        throw text::Error(token.place,
                          fmt::format("{} is one of {}, not {}", argument.name,
                                      fmt::join(argument.choices, ", "), describe(token)),
                          text::did_you_mean(token.text, argument.choices));
      }
      typed.word = text::lower(tokens_.take().text);
      return;
    }
    const ExpressionStyle style = more_numbers() ? ExpressionStyle::argument : ExpressionStyle::command;
    typed.expressions.push_back(ExpressionParser(tokens_, names_, style).expression());
    typed.place = typed.expressions.front()->place;
  }

  // Whether more than one number at its place in the line is still to come: `vc 1 -2` are two.
  bool more_numbers() const {
    return 1 <
           std::count_if(command_.arguments.begin(), command_.arguments.end(), [&](const Argument& argument) {
             const bool number =
                 argument.kind == ArgumentKind::number || argument.kind == ArgumentKind::count;
             return number && !argument.named && !given(argument);
           });
  }

  // A quoted string, a string variable, or the bare path.
  void file(TypedArgument& typed) {
    const std::string_view word = tokens_.bare_word_ahead();
    const bool is_value =
        tokens_.text_ahead().starts_with('"') || text::lower(word) == "sprintf" || is_known_name(word);
    if (is_value) {
      typed.expressions.push_back(expressions().expression());
      typed.place = typed.expressions.front()->place;
      return;
    }
    bare_word(typed);
  }

  void bare_word(TypedArgument& typed) {
    const Token word = tokens_.take_bare_word();
    typed.word = word.content;
    typed.place = word.place;
  }

  void numbers(TypedArgument& typed) {
    const bool bracketed = tokens_.peek().is_symbol("(");
    std::optional<language::Brackets> brackets;
    if (bracketed) {
      tokens_.take();
      brackets.emplace(tokens_);
    }
    for (std::size_t i = 0; i < typed.argument->how_many; ++i) {
      if (i > 0 && !tokens_.peek().is_symbol(",")) {
        throw text::Error(tokens_.peek().place,
                          fmt::format("{} takes {} numbers, found {} after {}", typed.argument->name,
                                      typed.argument->how_many, describe(tokens_.peek()), i),
                          "separate them by commas, as in (1, 0, 0)");
      }
      if (i > 0) tokens_.take();
      typed.expressions.push_back(expressions().expression());
    }
    if (bracketed && !tokens_.peek().is_symbol(")")) {
      throw text::Error(tokens_.peek().place,
                        fmt::format("expected \")\", found {}", describe(tokens_.peek())));
    }
    if (bracketed) tokens_.take();
  }

  // (fx, fy, fz), or the word for none.
  void formulas(TypedArgument& typed) {
    if (!typed.argument->word_for_none.empty() && tokens_.peek().is_word(typed.argument->word_for_none)) {
      typed.word = text::lower(tokens_.take().text);
      return;
    }
    const auto expect = [&](std::string_view symbol) {
      if (tokens_.peek().is_symbol(symbol)) return;
      throw text::Error(tokens_.peek().place,
                        fmt::format("expected \"{}\", found {}", symbol, describe(tokens_.peek())),
                        fmt::format("{} is three formulas, as in (0, 0, -1)", typed.argument->name));
    };
    expect("(");
    tokens_.take();
    const language::Brackets brackets(tokens_);
    typed.formulas.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      typed.formulas->formula.component[axis] = language::parse_formula(
          tokens_, language::FormulaKind::space, names_.variables(), scene::vertex_state_names);
      expect(axis < 2 ? "," : ")");
      tokens_.take();
    }
  }

  // The name of the element in turn holds in the arguments that follow, too.
  void generator(TypedArgument& typed) {
    const std::uint32_t begin = tokens_.mark();
    typed.generator = expressions().generator();
    typed.word = tokens_.peek().place.source->content.substr(begin, tokens_.previous_end() - begin);
    typed.place = typed.generator->place;
  }

  void list(TypedArgument& typed) {
    do {
      if (!typed.expressions.empty()) tokens_.take();
      typed.expressions.push_back(expressions().expression());
    } while (tokens_.peek().is_symbol(","));
  }

  // elements attribute [value] [where condition]
  void setting(TypedArgument& typed) {
    ExpressionParser parser = expressions();
    typed.generator = parser.generator(true);
    if (tokens_.peek().is_symbol(".")) tokens_.take();
    language::ElementPath in_turn;
    in_turn.local = typed.generator->slot;
    in_turn.root_kind = typed.generator->kind;
    in_turn.place = tokens_.peek().place;
    typed.place = tokens_.peek().place;
    typed.attribute = parser.attribute(std::move(in_turn));
    if (tokens_.peek().is_symbol("=") || tokens_.peek().is_symbol(":=")) tokens_.take();
    if (!language::at_command_end(tokens_) && !tokens_.peek().is_word("where"))
      typed.expressions.push_back(parser.expression());
    parser.where_clause(*typed.generator);
  }

  // NAME TYPE or ELEMENT attribute NAME TYPE, with sizes in brackets
  void definition(TypedArgument& typed) {
    if (const auto kind = language::element_kind(tokens_.peek().text);
        kind && tokens_.peek(1).is_word("attribute")) {
      typed.attribute_of = kind;
      tokens_.take();
      tokens_.take();
    }
    const Token name = expect_word("the new name");
    typed.word = std::string(name.text);
    typed.place = name.place;
    const Token type = expect_word("a type: real, integer or string");
    typed.type = text::lower(type.text);
    if (typed.type != "real" && typed.type != "integer" && typed.type != "string") {
      throw text::Error(type.place, fmt::format("{} is no type", describe(type)),
                        "types are real, integer and string");
    }
    std::optional<std::vector<int>> shape = std::vector<int>{};
    while (tokens_.peek().is_symbol("[")) {
      const Token opener = tokens_.take();
      const language::Brackets brackets(tokens_);
      typed.expressions.push_back(expressions().expression());
      const std::optional<int> size = names_.present_size(*typed.expressions.back());
      if (size && shape) shape->push_back(*size);
      if (!size) shape.reset();
      if (!tokens_.peek().is_symbol("]")) {
        throw text::Error(opener.place, "this \"[\" is never closed: missing \"]\"");
      }
      tokens_.take();
    }
    if (!typed.attribute_of) {
      names_.promise_variable(name.text);
    } else if (shape) {
      names_.promise_attribute(*typed.attribute_of, name.text, *shape);
    } else {
      names_.set_brings_names();
    }
  }

  Token expect_word(std::string_view what) {
    if (!tokens_.peek().is(TokenKind::word)) {
      throw text::Error(tokens_.peek().place,
                        fmt::format("expected {}, found {}", what, describe(tokens_.peek())),
                        "usage: " + usage(command_));
    }
    return tokens_.take();
  }

  // A procedure's name alone, or a value.
  void printable(TypedArgument& typed) {
    const Token& token = tokens_.peek();
    const bool value = is_known_value(token);
    if (token.is(TokenKind::word) && !value && names_.procedure(token.text) &&
        !tokens_.peek(1).is_symbol("(")) {
      typed.word = text::lower(tokens_.take().text);
      return;
    }
    typed.expressions.push_back(expressions().expression());
  }

  // In terms of a facet, or else of a vertex, or else of an edge; where none will do, what is wrong with the
  // first is told. A kind named first (`vertex z`) leaves no choice.
  void field(TypedArgument& typed) {
    using language::ElementKind;
    std::vector<ElementKind> kinds = {typed.argument->first_kind, ElementKind::facet, ElementKind::vertex,
                                      ElementKind::edge};
    const auto named = language::element_kind(tokens_.peek().text);
    if (named && *named != ElementKind::body && !tokens_.peek(1).is_symbol("[")) {
      kinds = {*named};
      tokens_.take();
    }
    const std::uint32_t begin = tokens_.mark();
    std::optional<text::Error> refused;
    for (const ElementKind kind : kinds) {
      tokens_.rewind(begin);
      const language::LocalNames local(names_);
      typed.field.kind = kind;
      typed.field.slot = names_.locals().declare({}, kind);
      try {
        typed.expressions.push_back(expressions().expression());
      } catch (const language::Incomplete&) {
        throw;
      } catch (const text::Error& error) {
        if (!refused) refused = error;
        continue;
      }
      typed.place = typed.expressions.front()->place;
      const std::string& content = typed.place.source->content;
      typed.field.text = content.substr(begin, tokens_.previous_end() - begin);
      return;
    }
    throw text::Error(*refused);
  }

  // (elements, value)
  void sample(TypedArgument& typed) {
    expect_symbol("(");
    const language::Brackets brackets(tokens_);
    generator(typed);
    expect_symbol(",");
    typed.expressions.push_back(expressions().expression());
    expect_symbol(")");
  }

  void expect_symbol(std::string_view symbol) {
    if (!tokens_.peek().is_symbol(symbol)) {
      throw text::Error(tokens_.peek().place,
                        fmt::format("expected \"{}\", found {}", symbol, describe(tokens_.peek())),
                        "usage: " + usage(command_));
    }
    tokens_.take();
  }

  void commands(TypedArgument& typed) {
    if (!tokens_.peek().is_symbol("{")) {
      throw text::Error(tokens_.peek().place,
                        fmt::format("expected commands in braces, found {}", describe(tokens_.peek())),
                        "usage: " + usage(command_));
    }
    typed.commands = language::StatementParser(tokens_, names_).next();
  }

  const Command& command_;
  LexerStream& tokens_;
  Names& names_;
  Token word_;
  Invocation* result_ = nullptr;
};

}  // namespace

std::unique_ptr<const Invocation> parse_command_call(const Command& command, LexerStream& tokens,
                                                     Names& names) {
  const language::LocalNames local(names);
  return ArgumentParser(command, tokens, names).run();
}

}  // namespace lamella::session
