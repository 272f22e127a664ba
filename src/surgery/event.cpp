#include "surgery/event.h"

#include <algorithm>

namespace lamella::surgery {

std::string_view name_of(EventKind kind) {
  switch (kind) {
    case EventKind::t1:
      return "t1";
    case EventKind::vanish:
      return "vanish";
    case EventKind::pinch:
      return "pinch";
    case EventKind::pop:
      return "pop";
    case EventKind::merge:
      return "merge";
    case EventKind::burst:
      return "burst";
    case EventKind::split:
      return "split";
    case EventKind::join:
      return "join";
    case EventKind::birth:
      return "birth";
  }
  return "";
}

std::vector<film::Region> regions_at(const film::Film& film, std::span<const film::Triangle> facets) {
  std::vector<film::Region> regions;
  for (const film::Triangle t : facets) {
    regions.push_back(film.regions(t).front);
    regions.push_back(film.regions(t).behind);
  }
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  return regions;
}

}  // namespace lamella::surgery
