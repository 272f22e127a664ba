// What names mean at the prompt: the scene's variables and procedures, internal variables, attributes,
// commands.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>

#include "language/statement_parser.h"
#include "scene/scene.h"
#include "session/attributes.h"
#include "session/command.h"

namespace lamella::session {

// A command's word in any spelling that is allowed: single letters by case, words without. Null if there is
// none.
const Command* find_command(std::span<const Command* const> commands, std::string_view word);

class Names : public language::StatementScope {
 public:
  Names(scene::Scene& scene, Attributes& attributes, std::span<const Command* const> commands)
      : scene_(scene), attributes_(attributes), commands_(commands) {}

  std::optional<language::VariableId> variable(std::string_view name) const override;
  std::optional<language::InternalId> internal(std::string_view name) const override;
  std::optional<language::AttributeMeaning> attribute(language::ElementKind kind,
                                                      std::string_view name) const override;
  std::optional<int> number_named(language::AttributeId attribute, std::string_view name) const override;
  std::optional<language::Arity> user_function(std::string_view name) const override;
  bool has_elements() const override { return true; }
  void collect_names(std::vector<std::string>& into) const override;
  void collect_parts(std::string_view name, std::vector<std::string>& into) const override;
  void collect_attributes(language::ElementKind kind, std::vector<std::string>& into) const override;

  std::optional<std::size_t> procedure(std::string_view name) const override;
  language::VariableId promise_variable(std::string_view name) override;
  void promise_procedure(std::string_view name, std::size_t parameters, bool returns_value) override;
  // An attribute that the text defines before it uses it.
  void promise_attribute(language::ElementKind kind, std::string_view name, std::vector<int> shape);
  bool is_command(std::string_view word) const override { return find_command(commands_, word) != nullptr; }
  std::string why_refused(std::string_view word) const override;
  std::unique_ptr<const language::CommandCall> parse_command(language::LexerStream& tokens) override;
  void collect_statement_words(std::vector<std::string>& into) const override;

  // The value of an array's size, as far as it is known before the text runs.
  std::optional<int> present_size(const language::Expression& size) const;
  // Whether one of the commands parsed since the last call may bring names that cannot be known yet.
  void set_brings_names() { brings_names_ = true; }
  bool take_brings_names() { return std::exchange(brings_names_, false); }
  // At the end of a text: what it promised and did not do is unknown again.
  void forget_promises();

  std::span<const Command* const> commands() const { return commands_; }
  const language::Variables& variables() const { return scene_.variables; }

 private:
  struct Promise {
    std::size_t parameters = 0;
    bool returns_value = false;
  };

  scene::Scene& scene_;
  Attributes& attributes_;
  std::span<const Command* const> commands_;
  std::set<std::uint32_t> promised_variables_;
  std::map<std::string, Promise, std::less<>> promised_procedures_;
  bool brings_names_ = false;
};

}  // namespace lamella::session
