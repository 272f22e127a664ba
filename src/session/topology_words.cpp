#include "session/topology_words.h"

#include "session/mesh_commands.h"
#include "session/session.h"
#include "surgery/regions.h"

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

void finish_topology(Session& session, std::vector<surgery::Event> events) {
  surgery::settle_regions(session.scene(), events, {});
  finish_surgery(session);
  for (const surgery::Event& event : events) session.tell("{}\n", describe(event));
}

}  // namespace lamella::session
