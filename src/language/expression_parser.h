// Parses expressions, elements and generators of elements.
//
// From what binds most to what binds least:
//   ^ **                    from the left; 2^-1^2 is 2^(-(1^2))
//   - + before an operand
//   * / % mod imod idiv     from the left
//   + -                     from the left
//   == != < > <= >=         from the right
//   ! not                   !a == b is !(a == b)
//   && and                  from the left
//   || or                   from the left
//   ? :                     from the right
//   =                       from the left: a minus, so that x^2 + y^2 = 1 is a formula that vanishes on the
//   circle
#pragma once

#include "language/lexer.h"
#include "language/scope.h"
#include "language/token.h"

namespace lamella::language {

enum class ExpressionStyle : std::uint8_t {
  // Values one after the other on a line: a '-' after white space and stuck to what follows begins a new one
  // (`3 - 5` and `3-5` are one, `3 -5` are two). An expression ends with its line.
  values,
  // A formula on a line of a datafile: `x -y` is a difference.
  formula,
  // The same in a command, where an expression that cannot end goes on on the next line, and `> "file"`
  // redirects.
  command,
  // The same where no output can be redirected: `> "text"` compares.
  condition,
  // The same in a command where more values may follow: a '-' as in `values`.
  argument,
};

class ExpressionParser {
 public:
  ExpressionParser(TokenStream& tokens, Scope& scope, ExpressionStyle style)
      : tokens_(tokens), scope_(scope), style_(style) {}

  // All throw text::Error at the first token that does not fit, Incomplete if a command breaks off.
  ExpressionPointer expression();

  // Whether the next token begins an element or a generator of elements.
  bool at_elements();
  // Whether an attribute of an element comes next, as in edge[5].length; not edge[5] alone.
  bool at_attribute();
  ElementPath element();
  // Declares the element in turn (with its name, if one follows) in the scope; the caller forgets it
  // (LocalNames). A word that `attribute_follows` is no name: `set vertex x 3`.
  Generator generator(bool attribute_follows = false);
  // The clause `where condition`, if it is there.
  void where_clause(Generator& generator);
  // The internal value `name.part`, such as volume.target of a quantity, if one is named next; taken then.
  std::optional<InternalId> dotted_internal(text::Place& place);
  // The same of a variable whose name has a dot.
  std::optional<VariableId> dotted_variable(text::Place& place);
  // Throws where a name that has parts is followed by a dot and what is none of them ("height.pscal").
  void refuse_unknown_part();
  // The indices that follow an array's name.
  std::vector<ExpressionPointer> array_indices(text::Place& place);
  // Numbers in braces, which come next.
  ExpressionPointer array_literal();
  // The attribute of an element of this kind that is named next.
  AttributeUse attribute(ElementPath of);

  TokenStream& tokens() { return tokens_; }
  Scope& scope() { return scope_; }

 private:
  std::string dotted_name();
  text::Place take_dotted();
  class Level;
  class Enclosed;
  struct Operator {
    int rank = 0;
    BinaryOperator operation = BinaryOperator::add;
    bool conditional = false;
  };

  ExpressionPointer ranked(int lowest);
  ExpressionPointer prefix();
  ExpressionPointer primary();
  ExpressionPointer word();
  std::optional<Operator> binary_operator();
  bool in_command() const { return style_ >= ExpressionStyle::command; }
  ExpressionPointer conditional(ExpressionPointer condition);
  ExpressionPointer parentheses();
  ExpressionPointer string();
  ExpressionPointer call(const Function& function);
  ExpressionPointer user_call(const Arity& arity);
  ExpressionPointer variable(VariableId id);
  ExpressionPointer aggregate(AggregateKind kind);
  ExpressionPointer special_call();
  ExpressionPointer attribute_of_element();
  ExpressionPointer local_or_attribute();
  std::vector<ExpressionPointer> arguments(const Token& name, std::optional<std::size_t> wanted);
  ExpressionPointer bracketed_index(text::Place& place);
  ExpressionPointer following_number(AttributeId attribute, text::Place& place);
  ElementPath element_in_turn(const Local& local, const text::Place& place) const;

  std::size_t path_end(std::size_t ahead);
  bool aggregate_ahead();
  bool accept(std::string_view symbol);
  bool accept_comma();
  text::Place close(std::string_view symbol, const Token& opener);
  [[noreturn]] void unexpected(std::string_view wanted, std::string_view after = {});
  [[noreturn]] void unknown_name(const Token& name);

  TokenStream& tokens_;
  Scope& scope_;
  ExpressionStyle style_;
  std::string_view waiting_operator_;  // the one whose right operand comes next
  int depth_ = 0;                      // of the tree so far
  int brackets_ = 0;                   // open around the next token
};

// The nearest names to a misspelt one among variables, functions, constants and attributes.
std::string suggest_name(std::string_view name, const Scope& scope);

}  // namespace lamella::language
