// Which facets pictures show unless they are told.
#pragma once

#include <optional>
#include <string>

#include "session/session.h"

namespace lamella::session {

// From now on those that `text` picks out when a picture is drawn: `facets where color == red`.
void show_only(Session& session, const std::string& text);

// Nothing if all are shown.
std::optional<Elements> shown_facets(Session& session);

}  // namespace lamella::session
