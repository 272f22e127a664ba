// Pictures drawn in the terminal itself.
#pragma once

#include <string>

#include "picture/show.h"
#include "session/session.h"

namespace lamella::session {

// Whether what the session prints goes to a terminal that shows pictures.
bool shows_in_terminal(Session& session);

// A picture as text for the terminal, as large as its window with room for the prompt; how many lines it
// takes.
struct TerminalPicture {
  std::string text;
  int lines = 0;
};
// Asks the terminal what it can do when called first. A width or height that `options` were given by the
// person counts where the terminal draws pixels.
TerminalPicture terminal_picture(Session& session, const scene::Scene& scene,
                                 const picture::PictureOptions& options, bool own_size);

}  // namespace lamella::session
