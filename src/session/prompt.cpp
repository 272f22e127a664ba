#include "session/prompt.h"

#include "session/session.h"

namespace lamella::session {

void run_prompt(Session&) {}

}  // namespace lamella::session
