// What happened to the film: changes of its topology, for whoever logs them.
#pragma once

#include <string_view>
#include <vector>

#include "film/film.h"

namespace lamella::surgery {

enum class EventKind {
  t1,      // neighbours swapped: a border or a face shrank to a point, and another grew
  vanish,  // a small region, or piece of film, shrank to nothing
  pinch,   // a neck closed, or films that met in a point alone came apart
  pop,     // an edge or a point that no soap film keeps was resolved
  merge,   // two films touched and became one
  burst,   // a film was taken out
  split,   // a region fell apart
  join,    // two regions became one
  birth,   // films closed around a new region
};

std::string_view name_of(EventKind kind);

struct Event {
  EventKind kind = EventKind::t1;
  film::Vec3 place;
  std::vector<film::Region> regions;  // concerned, each once, ascending
};

// The regions on both sides of some facets, each once, ascending.
std::vector<film::Region> regions_at(const film::Film& film, std::span<const film::Triangle> facets);

}  // namespace lamella::surgery
