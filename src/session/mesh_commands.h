// What the commands that change the mesh have in common.
#pragma once

#include <string_view>

#include "session/session.h"
#include "surgery/collapse_edge.h"

namespace lamella::session {

// Throws text::Error where there is no film; `what` is what it would be for: "to refine".
void check_film(Session& session, std::string_view what);

// After surgery: rows close up, and vertices that were moved go back onto what holds them.
void finish_surgery(Session& session);

// Collapses the edges, or facets, of a selection one after the other: whether one is meant is asked when its
// turn comes, as collapses move others. Sets the counters; returns how many there were.
long collapse_selected(Session& session, const language::Generator& generator);

}  // namespace lamella::session
