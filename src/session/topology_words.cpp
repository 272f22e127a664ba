#include "session/topology_words.h"

#include <cstdio>

#include "session/mesh_commands.h"
#include "session/session.h"
#include "surgery/regions.h"
#include "text/whole_file.h"

namespace lamella::session {

namespace {

// What is nearly zero is rounding.
double rounded(double coordinate) {
  return std::abs(coordinate) < 1e-12 ? 0 : coordinate;
}

}  // namespace

std::string describe(const surgery::Event& event) {
  std::string line = fmt::format("{} at ({:.4g}, {:.4g}, {:.4g})", name_of(event.kind),
                                 rounded(event.place.x), rounded(event.place.y), rounded(event.place.z));
  std::string bodies;
  for (const film::Region r : event.regions) {
    if (!r.outside()) bodies += fmt::format(" {}", r.index);
  }
  return bodies.empty() ? line : line + ", bodies" + bodies;
}

void EventLog::begin(std::string path) {
  text::write_whole_file(path, "time,event,x,y,z,bodies\n");
  path_ = std::move(path);
}

void EventLog::note(double time, const surgery::Event& event) const {
  std::string bodies;
  for (const film::Region r : event.regions) {
    if (!r.outside()) bodies += fmt::format("{}{}", bodies.empty() ? "" : " ", r.index);
  }
  const std::string row = fmt::format("{},{},{},{},{},{}\n", time, name_of(event.kind), event.place.x,
                                      event.place.y, event.place.z, bodies);
  std::FILE* const file = std::fopen(path_.c_str(), "a");
  const bool written = file != nullptr && std::fwrite(row.data(), 1, row.size(), file) == row.size();
  if (file != nullptr && std::fclose(file) == 0 && written) return;
  throw text::Error(fmt::format("cannot write \"{}\"", path_));
}

void tell_events(Session& session, std::span<const surgery::Event> events) {
  const EventLog& log = session.memory<EventLog>();
  const double time = session.scene().time;
  for (const surgery::Event& event : events) {
    session.tell("time {:.6g}: {}\n", time, describe(event));
    if (log.active()) log.note(time, event);
  }
  for (const surgery::Event& event : events) {
    const auto& hooks = session.memory<EventHooks>().commands;
    const auto hook = hooks.find(std::string(name_of(event.kind)));
    if (hook != hooks.end()) session.run_within(*hook->second);
  }
}

void finish_topology(Session& session, std::vector<surgery::Event> events) {
  // The regions of the string model are its cells', which keep theirs.
  if (!session.scene().strings.on) surgery::settle_regions(session.scene(), events, {});
  finish_surgery(session);
  tell_events(session, events);
}

}  // namespace lamella::session
