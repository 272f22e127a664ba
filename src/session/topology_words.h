// Changes of topology, told.
#pragma once

#include <string>

#include "surgery/event.h"

namespace lamella::session {

class Session;

// `t1 at (0.1, 0.2, 0.3), bodies 1 2 4`
std::string describe(const surgery::Event& event);

// After a command that changed the topology: regions are brought up to date, rows close up, and a line is
// told for each event.
void finish_topology(Session& session, std::vector<surgery::Event> events);

}  // namespace lamella::session
