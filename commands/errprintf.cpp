#include "language/format.h"
#include "session/session.h"
#include "session/terminal.h"

namespace lamella::session::commands {

namespace {

struct ErrprintfOptions {
  Expressions values;
};

void run(Session& session, const ErrprintfOptions& options) {
  const std::vector<const language::Expression*>& given = options.values.list;
  const std::string format = evaluate_text(*given.front(), session.evaluation());
  std::vector<language::Value> values;
  for (std::size_t i = 1; i < given.size(); ++i) values.push_back(evaluate(*given[i], session.evaluation()));
  try {
    session.output().flush();
    write_error(language::format_values(format, values));
  } catch (const text::Error& error) {
    throw error.placed_at(given.front()->place);
  }
}

}  // namespace

extern const Command errprintf_command = make_command<ErrprintfOptions>(
    {.name = "errprintf", .summary = "printf to the standard error output", .group = CommandGroup::output},
    {positional("format", &ErrprintfOptions::values, "\"format\", value, value, ...").required()}, run);

}  // namespace lamella::session::commands
