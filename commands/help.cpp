#include "session/help.h"

#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct HelpOptions {
  std::optional<Word> topic;
};

void run(Session& session, const HelpOptions& options) {
  if (!options.topic) {
    session.write(help_overview(session));
    return;
  }
  try {
    session.write(help_topic(session, options.topic->text));
  } catch (const text::Error& error) {
    throw error.placed_at(options.topic->place);
  }
}

}  // namespace

extern const Command help_command =
    make_command<HelpOptions>({.name = "help",
                               .aliases = {"h", "H"},
                               .summary = "list the commands, or tell about one, or about any name",
                               .group = CommandGroup::session},
                              {positional("topic", &HelpOptions::topic,
                                          "a command, function, variable or attribute; or: language, error")},
                              run);

}  // namespace lamella::session::commands
