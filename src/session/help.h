// What `help` prints.
#pragma once

#include <string>
#include <string_view>

namespace lamella::session {

class Session;

// The commands in groups, one line each.
std::string help_overview(Session& session);

// About a command, a function, a variable, an attribute or a word of the language. Throws text::Error with
// the nearest topic where there is none.
std::string help_topic(Session& session, std::string_view topic);

// Markdown made readable on a terminal: headings stand out, marks go, tables stand in columns.
std::string readable(std::string_view markdown, bool colours);

}  // namespace lamella::session
