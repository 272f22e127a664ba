// The prompt: lines typed with readline, their history and completion.
#pragma once

namespace lamella::session {

class Session;

// Until `quit` or the end of the input.
void run_prompt(Session& session);

}  // namespace lamella::session
