#include "language/format.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct PrintfOptions {
  Expressions values;
};

void run(Session& session, const PrintfOptions& options) {
  const std::vector<const language::Expression*>& given = options.values.list;
  const std::string format = evaluate_text(*given.front(), session.evaluation());
  std::vector<language::Value> values;
  for (std::size_t i = 1; i < given.size(); ++i) values.push_back(evaluate(*given[i], session.evaluation()));
  try {
    session.write(language::format_values(format, values));
  } catch (const text::Error& error) {
    throw error.placed_at(given.front()->place);
  }
}

}  // namespace

extern const Command printf_command = make_command<PrintfOptions>(
    {.name = "printf", .summary = "print values by a format, as in C", .group = CommandGroup::output},
    {positional("format", &PrintfOptions::values, "\"format\", value, value, ...").required()}, run);

}  // namespace lamella::session::commands
