#include "datafile/attributes.h"
#include "session/follow_formulas.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct SetOptions {
  Setting setting;
};

bool is_flag(Session& session, const Setting& setting) {
  const AttributeRow& row = session.attributes().row(setting.attribute->attribute);
  if (row.takes_number) return true;
  const datafile::KnownColumn* const known = datafile::known_column(film_kind(row.kind), row.column);
  return known != nullptr && known->type == datafile::KnownColumn::Type::flag;
}

bool moves_vertices(Session& session, const Setting& setting) {
  const AttributeRow& row = session.attributes().row(setting.attribute->attribute);
  return row.kind == language::ElementKind::vertex && (row.name == "x" || row.name == "y" || row.name == "z");
}

void run(Session& session, const SetOptions& options) {
  const Setting& setting = options.setting;
  language::Evaluation& evaluation = session.evaluation();
  if (setting.value == nullptr && !is_flag(session, setting)) {
    throw text::Error(setting.place, "this attribute needs its value",
                      "only yes-or-no attributes such as fixed need none");
  }
  const AttributeSource source = session.attribute_source();
  std::vector<std::uint32_t> moved;
  const bool moves = moves_vertices(session, setting);
  for_each_element(*setting.generator, evaluation, [&](const language::Element& element) {
    const double value = setting.value == nullptr ? 1 : evaluate_number(*setting.value, evaluation);
    const int component = evaluate_component(*setting.attribute, evaluation);
    try {
      session.attributes().set(source, setting.attribute->attribute, element, component, value);
    } catch (const text::Error& error) {
      throw error.placed_at(setting.place);
    }
    if (moves) moved.push_back(element.row);
    return true;
  });
  follow_constraints(session.scene(), moved);
}

}  // namespace

extern const Command set_command = make_command<SetOptions>(
    {.name = "set", .summary = "give attributes of elements values", .group = CommandGroup::scene},
    {positional("elements attribute [value] [where condition]", &SetOptions::setting, "").required()}, run);

}  // namespace lamella::session::commands
