#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct LinearOptions {
  long model = 1;
};

void run(Session& session, const LinearOptions& options) {
  if (options.model != 1) {
    throw text::Error(
        fmt::format("model {} is not supported: facets are flat and edges straight here", options.model),
        "refine in its place");
  }
  session.tell("Model already LINEAR.\n");
}

}  // namespace

extern const Command linear_command =
    make_command<LinearOptions>({.name = "linear",
                                 .aliases = {"M"},
                                 .summary = "the model of flat facets, the only one there is",
                                 .group = CommandGroup::scene},
                                {positional("model", &LinearOptions::model, "1")}, run);

}  // namespace lamella::session::commands
