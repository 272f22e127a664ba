#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ConjugateOptions {
  std::optional<std::string> state;
};

void run(Session& session, const ConjugateOptions& options) {
  bool& conjugate = session.scene().conjugate_gradient;
  const bool before = conjugate;
  conjugate = options.state ? *options.state == "on" : !before;
  session.tell("Conjugate gradient now {}. (was {})\n", conjugate ? "ON" : "OFF", before ? "on" : "off");
}

}  // namespace

extern const Command conj_grad_command = make_command<ConjugateOptions>(
    {.name = "conj_grad",
     .aliases = {"U"},
     .summary = "whether g goes by conjugate directions; turned around unless given",
     .group = CommandGroup::motion},
    {positional("state", &ConjugateOptions::state, "turned around unless given").one_of({"on", "off"})}, run);

}  // namespace lamella::session::commands
