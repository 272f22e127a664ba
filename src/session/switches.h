// What is on or off: words such as `gravity` and `autorecalc`, each a command (`gravity off`) and a value.
#pragma once

#include <span>
#include <string_view>

#include "session/command.h"

namespace lamella::session {

enum class SwitchEffect : std::uint8_t {
  acts,     // does what it says
  kept,     // concerns windows, files or methods that are not like this here: its state is kept, no more
  refused,  // would change what steps do, and is not supported: off is accepted, on is refused
};

struct Switch {
  std::string_view name;
  SwitchEffect effect = SwitchEffect::kept;
  bool initial = false;
  std::string_view letter = {};     // flips it
  std::string_view why = {};        // it is refused
  bool (*get)(Session&) = nullptr;  // of one that acts
  void (*set)(Session&, bool on) = nullptr;
};

std::span<const Switch> switches();
// Null if there is none. Letters by case, words without.
const Switch* find_switch(std::string_view word);
bool is_on(Session& session, const Switch& known);
// As they are when a scene is loaded; what belongs to the scene, or to the session, stays.
void reset_switches(Session& session);
// Throws text::Error where the switch is refused.
void turn(Session& session, const Switch& known, bool on);

// The switch as a command; null if there is none.
const Command* find_switch_command(std::string_view word);

}  // namespace lamella::session
