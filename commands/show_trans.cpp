#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ShowTransOptions {
  std::string keys;
};

// Keys that turn the picture in a window, of which there is none.
void run(Session&, const ShowTransOptions&) {}

}  // namespace

extern const Command show_trans_command = make_command<ShowTransOptions>(
    {.name = "show_trans",
     .summary = "accepted, for datafiles turn their window by it; view turns pictures",
     .group = CommandGroup::output},
    {positional("keys", &ShowTransOptions::keys, "such as \"rrd\"").required()}, run);

}  // namespace lamella::session::commands
