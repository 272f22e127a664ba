// Any bytes as commands: they parse, or text::Error. Commands proper take what stands up to their end.
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "language/statement_parser.h"
#include "language/variables.h"
#include "text/error.h"
#include "text/suggest.h"

using namespace lamella;

namespace {

struct Skipped : language::CommandCall {};

class FuzzScope : public language::StatementScope {
 public:
  std::optional<language::VariableId> variable(std::string_view name) const override {
    return variables_.find_id(name);
  }
  std::optional<language::InternalId> internal(std::string_view name) const override {
    return name == "total_area" ? std::optional(language::InternalId{0}) : std::nullopt;
  }
  std::optional<language::AttributeMeaning> attribute(language::ElementKind,
                                                      std::string_view name) const override {
    if (name == "x" || name == "id") return language::AttributeMeaning{{0}, {}};
    if (name == "flow") return language::AttributeMeaning{{1}, {3, 2}};
    return std::nullopt;
  }
  std::optional<language::Arity> user_function(std::string_view name) const override {
    const auto at = procedures_.find(text::lower(name));
    if (at == procedures_.end()) return std::nullopt;
    return language::Arity{at->second, at->second};
  }
  bool has_elements() const override { return true; }
  std::optional<std::size_t> procedure(std::string_view name) const override {
    const auto at = procedures_.find(text::lower(name));
    return at == procedures_.end() ? std::nullopt : std::optional(at->second);
  }
  language::VariableId promise_variable(std::string_view name) override {
    const language::VariableId id = variables_.id(name);
    variables_.set(id, 0.0);
    return id;
  }
  void promise_procedure(std::string_view name, std::size_t parameters, bool) override {
    procedures_[text::lower(name)] = parameters;
  }
  bool is_command(std::string_view word) const override {
    return word == "g" || word == "print" || word == "set" || word == "refine";
  }
  std::string why_refused(std::string_view word) const override { return word == "pop" ? "no" : ""; }
  std::unique_ptr<const language::CommandCall> parse_command(language::LexerStream& tokens) override {
    tokens.take();
    const language::LocalNames local(*this);
    language::ExpressionParser parser(tokens, *this, language::ExpressionStyle::argument);
    while (!language::at_command_end(tokens)) {
      if (parser.at_elements()) {
        parser.generator();
      } else {
        parser.expression();
      }
    }
    return std::make_unique<Skipped>();
  }
  void collect_statement_words(std::vector<std::string>&) const override {}

 private:
  language::Variables variables_;
  std::map<std::string, std::size_t> procedures_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzScope scope;
  try {
    language::LexerStream tokens(
        language::Lexer(text::make_source("fuzz", std::string(reinterpret_cast<const char*>(bytes), size)),
                        language::LexerMode::command));
    language::StatementParser parser(tokens, scope);
    for (bool more = true; more;) {
      const std::uint32_t begin = tokens.previous_end();
      try {
        more = parser.next() != nullptr;
      } catch (const text::Error&) {
        tokens.rewind(begin);
        parser.skip_statement_line();
        if (tokens.previous_end() <= begin) more = false;
      }
    }
  } catch (const text::Error&) {
  }
  return 0;
}
