// Runs statements on a session: where the language meets the scene.
#pragma once

#include "language/interpreter.h"
#include "session/element_access.h"

namespace lamella::session {

class Session;

// Ctrl-C: the run ends, what it has done stays.
class Interrupted {};

class Machine : public language::Host {
 public:
  explicit Machine(Session& session) : session_(session), evaluation_(*this) {}

  language::Evaluation& evaluation() { return evaluation_; }

  // --- values
  const language::Value& variable(language::VariableId id) override;
  const language::Array* array(language::VariableId id) override;
  language::Value internal(language::InternalId id) override;
  double attribute(language::AttributeId id, const language::Element& element, int component) override;
  bool is_defined(std::string_view name) override;
  std::shared_ptr<const std::vector<language::Element>> elements(language::ElementKind kind) override;
  bool exists(const language::Element& element) override;
  std::optional<language::Element> numbered(language::ElementKind kind, double number) override;
  std::vector<language::Element> parts(const language::Element& element, language::ElementKind kind) override;
  language::Value call(const std::string& function, std::span<const language::Value> arguments) override;

  // --- changes
  void assign(language::VariableId id, language::Value value) override;
  void make_permanent(language::VariableId id) override;
  void set_shape(language::VariableId id, const std::vector<int>& shape) override;
  void assign(language::VariableId id, std::size_t component, double value) override;
  void assign(language::InternalId id, const language::Value& value) override;
  void assign(language::AttributeId id, const language::Element& element, int component,
              double value) override;
  const language::Procedure* procedure(const std::string& name) override;
  void define(const language::Procedure& procedure) override;
  void run_command(const language::CommandCall& call, language::Evaluation& evaluation) override;
  void begin_redirection(language::Redirection kind, const std::string& target) override;
  void end_redirection() override;
  void cancel_redirection() override;
  void between_statements() override;
  std::uint64_t structure() override;
  double number(const language::Element& element) override;

 private:
  Session& session_;
  language::Evaluation evaluation_;
  ElementIndex index_;
};

}  // namespace lamella::session
