#include "language/formula_scope.h"

#include <array>

#include "language/expression_parser.h"

namespace lamella::language {

namespace {

// Passes tokens on and writes down what was taken. Between brackets, line ends are passed over.
class Transcript : public TokenStream {
 public:
  explicit Transcript(TokenStream& tokens) : tokens_(tokens) {}

  const Token& peek(std::size_t ahead) override {
    if (brackets_ > 0) pass_line_ends();
    if (ahead > 0 || separator_ == 0) return tokens_.peek(ahead);
    next_ = tokens_.peek();
    next_.space_before = true;
    if (next_.separator == 0) next_.separator = separator_;
    return next_;
  }

  Token take() override {
    Token token = peek(0);
    tokens_.take();
    separator_ = 0;
    write(token);
    return token;
  }

  void enter_brackets() override {
    ++brackets_;
    tokens_.enter_brackets();
  }
  void leave_brackets() override {
    --brackets_;
    tokens_.leave_brackets();
  }

  std::string text() const { return text_; }

 private:
  // A separator before a line end stands before what follows it.
  void pass_line_ends() {
    while (tokens_.peek().is(TokenKind::newline)) {
      const Token newline = tokens_.take();
      if (newline.separator != 0) separator_ = newline.separator;
    }
  }

  void write(const Token& token) {
    if (!text_.empty() && token.separator != 0) text_ += token.separator;
    if (token.is(TokenKind::newline)) {
      text_ += ' ';
      return;
    }
    // Words that a macro brought together must not merge, nor two signs become a comment or an operator.
    const bool signs = after_symbol_ && (token.is_symbol("-") || token.is_symbol("+"));
    const bool separate = token.space_before || signs || (!after_symbol_ && !token.is(TokenKind::symbol));
    if (!text_.empty() && text_.back() != ' ' && separate) text_ += ' ';
    text_ += token.text;
    after_symbol_ = token.is(TokenKind::symbol) && !token.is_symbol(")");
  }

  TokenStream& tokens_;
  Token next_;
  std::string text_;
  int brackets_ = 0;
  char separator_ = 0;  // that stood before a line end
  bool after_symbol_ = true;
};

}  // namespace

FormulaScope::FormulaScope(FormulaKind kind, const Variables& variables,
                           const std::vector<std::string>& attributes)
    : variables_(variables) {
  // The order of the slots is what Formula expects.
  if (kind == FormulaKind::variables) {
    for (int slot = 0; slot < 4; ++slot) locals().declare("");
    locals().declare(variables.find_id("g") ? "" : "g");
    return;
  }
  const bool space = kind != FormulaKind::parameter;
  for (const char* name : space ? std::array{"x", "y", "z"} : std::array{"p1", "p2", "p3"})
    locals().declare(name);
  locals().declare("total_time");
  locals().declare(variables.find_id("g") ? "" : "g");  // a variable of that name comes first
  for (const std::string& name : attributes) locals().declare(name);
  if (!space) return;
  for (const char* name : {"x1", "x2", "x3"}) locals().declare(name);
  if (kind != FormulaKind::space_and_normal) return;
  for (const char* name : {"x4", "x5", "x6"}) locals().declare(name);
}

std::optional<VariableId> FormulaScope::variable(std::string_view name) const {
  return ConstantScope(variables_).variable(name);
}

void FormulaScope::collect_names(std::vector<std::string>& into) const {
  ConstantScope(variables_).collect_names(into);
  for (const Local& local : locals().names()) into.push_back(local.name);
}

Formula parse_formula(TokenStream& tokens, FormulaKind kind, const Variables& variables,
                      const std::vector<std::string>& attributes, ExpressionStyle style) {
  FormulaScope scope(kind, variables, attributes);
  Transcript transcript(tokens);
  ExpressionParser parser(transcript, scope, style);
  std::shared_ptr<const Expression> expression = parser.expression();
  return Formula(std::move(expression), transcript.text(), attributes);
}

}  // namespace lamella::language
