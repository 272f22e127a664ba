#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct NormalOptions {
  std::optional<std::string> state;
};

void run(Session& session, const NormalOptions& options) {
  bool& normal = session.scene().hessian_normal;
  const bool before = normal;
  normal = options.state.value_or("on") == "on";
  session.tell("hessian_normal {} (was {})\n", normal ? " ON." : "OFF.", before ? "on" : "off");
}

}  // namespace

extern const Command hessian_normal_command = make_command<NormalOptions>(
    {.name = "hessian_normal",
     .summary = "whether Newton's method moves vertices along normals only",
     .group = CommandGroup::motion},
    {positional("state", &NormalOptions::state, "on unless given").one_of({"on", "off"})}, run);

}  // namespace lamella::session::commands
