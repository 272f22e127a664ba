#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct TransformOptions {
  std::string expression;
};

void run(Session& session, const TransformOptions& options) {
  session.scene().view_transforms = {options.expression, true};
}

}  // namespace

extern const Command transform_expr_command = make_command<TransformOptions>(
    {.name = "transform_expr",
     .summary = "how pictures repeat the scene, in terms of the datafile's generators",
     .group = CommandGroup::output},
    {positional("expression", &TransformOptions::expression, "such as \"3(a|b)\"").required()}, run);

}  // namespace lamella::session::commands
