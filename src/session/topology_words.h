// Changes of topology, told, logged, and answered.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "language/statement.h"
#include "surgery/event.h"

namespace lamella::session {

class Session;

// Whether evolve changes the topology of films; it does unless told otherwise.
struct TopologySwitch {
  bool on = true;
  bool keeps_energy = true;  // what changes of the mesh cost is given back
};

// What runs when films change their topology, by the kind of event.
struct EventHooks {
  std::map<std::string, std::shared_ptr<const language::Block>> commands;
};

// A table of events, one row each.
class EventLog {
 public:
  // Begins a file with its header. Throws text::Error where it cannot be written.
  void begin(std::string path);
  void end() { path_.clear(); }
  bool active() const { return !path_.empty(); }
  const std::string& path() const { return path_; }
  void note(double time, const surgery::Event& event) const;

 private:
  std::string path_;
};

// `t1 at (0.1, 0.2, 0.3), bodies 1 2 4`
std::string describe(const surgery::Event& event);

// Tells events, writes them into the log, and runs what is to run on them. The scene may change.
void tell_events(Session& session, std::span<const surgery::Event> events);

// After a command that changed the topology: regions are brought up to date, rows close up, and the events
// are told.
void finish_topology(Session& session, std::vector<surgery::Event> events);

}  // namespace lamella::session
