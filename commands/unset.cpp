#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct UnsetOptions {
  Setting setting;
};

void run(Session& session, const UnsetOptions& options) {
  const Setting& setting = options.setting;
  if (setting.value != nullptr)
    throw text::Error(setting.value->place, "unset takes no value", "set gives values");
  const AttributeSource source = session.attribute_source();
  for_each_element(*setting.generator, session.evaluation(), [&](const language::Element& element) {
    const AttributeRow& row = session.attributes().row(setting.attribute->attribute);
    const int component = row.takes_number ? evaluate_component(*setting.attribute, session.evaluation()) : 0;
    try {
      session.attributes().unset(source, setting.attribute->attribute, element, component);
    } catch (const text::Error& error) {
      throw error.placed_at(setting.place);
    }
    return true;
  });
}

}  // namespace

extern const Command unset_command = make_command<UnsetOptions>(
    {.name = "unset", .summary = "take attributes of elements away", .group = CommandGroup::scene},
    {positional("elements attribute [where condition]", &UnsetOptions::setting, "").required()}, run);

}  // namespace lamella::session::commands
