#include "session/show_filter.h"

#include "language/expression_parser.h"

namespace lamella::session {

namespace {

struct ShowFilter {
  std::string text;
};

}  // namespace

void show_only(Session& session, const std::string& text) {
  session.memory<ShowFilter>().text = text;
}

std::optional<Elements> shown_facets(Session& session) {
  const std::string& text = session.memory<ShowFilter>().text;
  if (text.empty()) return std::nullopt;
  using language::ExpressionStyle;
  language::LexerStream tokens(
      language::Lexer(text::make_source("show_expr", text), language::LexerMode::command));
  const language::Locals outer = std::exchange(session.names().locals(), {});
  std::optional<language::Generator> generator;
  try {
    generator = language::ExpressionParser(tokens, session.names(), ExpressionStyle::command).generator();
  } catch (...) {
    session.names().locals() = outer;
    throw;
  }
  const std::uint32_t slots = session.names().locals().slots();
  session.names().locals() = outer;
  const language::Evaluation::Frame frame(session.evaluation(), slots);
  return Elements{generator->kind, evaluate_elements(*generator, session.evaluation())};
}

}  // namespace lamella::session
