#include "surgery/burst.h"

#include <algorithm>
#include <map>

#include "surgery/patch.h"
#include "surgery/regions.h"

namespace lamella::surgery {

using film::Film;
using film::Region;
using film::RegionPair;
using film::Side;
using film::Triangle;
using film::Vec3;
using scene::Scene;

namespace {

double area_of(const Film& film, Triangle t) {
  const auto p = film.points(t);
  return 0.5 * length(cross(p[1] - p[0], p[2] - p[0]));
}

Vec3 middle_of(const Film& film, std::span<const Triangle> facets) {
  Vec3 sum;
  double area = 0;
  for (const Triangle t : facets) {
    const auto p = film.points(t);
    const double weight = area_of(film, t);
    sum += (weight / 3) * (p[0] + p[1] + p[2]);
    area += weight;
  }
  return area > 0 ? sum / area : sum;
}

bool any_fixed(const Film& film, std::span<const Triangle> facets) {
  return std::any_of(facets.begin(), facets.end(),
                     [&](Triangle t) { return is_fixed(film, film::ElementKind::facet, t.index); });
}

// The region that is left of two, and the one that is lost in it.
RegionPair left_and_lost(const Scene& scene, RegionPair pair) {
  if (pair.front.outside()) return pair;
  if (pair.behind.outside()) return pair.flipped();
  const auto volume = [&](Region r) { return scene.body(r).target_volume.value_or(0); };
  return volume(pair.front) >= volume(pair.behind) ? pair : pair.flipped();
}

Event take_out(Scene& scene, const std::vector<Triangle>& facets, RegionPair pair) {
  Event event{EventKind::burst, middle_of(scene.film, facets), {}};
  event.regions = regions_at(scene.film, facets);
  replace(scene.film, {facets, {}});
  if (pair.front != pair.behind) {
    const RegionPair ends = left_and_lost(scene, pair);
    join_regions(scene, ends.front, ends.behind);
  }
  return event;
}

}  // namespace

std::vector<Triangle> sheet_of(const Film& film, Triangle facet) {
  std::vector<std::uint8_t> met(film.triangle_rows());
  std::vector<Triangle> sheet{facet};
  met[facet.index] = 1;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Side s(sheet[i], k);
      const film::Edge e = film.edge_of(s).edge();
      if (film.valence(e) != 2 || is_fixed(film, film::ElementKind::edge, e.index)) continue;
      const Triangle other = film.next_around(s).triangle();
      if (met[other.index] == 0) sheet.push_back(other);
      met[other.index] = 1;
    }
  }
  std::sort(sheet.begin(), sheet.end());
  return sheet;
}

std::optional<Event> burst_sheet(Scene& scene, Triangle facet) {
  if (!scene.film.alive(facet)) return {};
  const std::vector<Triangle> sheet = sheet_of(scene.film, facet);
  if (any_fixed(scene.film, sheet)) return {};
  return take_out(scene, sheet, scene.film.regions(facet));
}

std::optional<Event> burst_body(Scene& scene, Region body) {
  const Film& film = scene.film;
  std::map<Region, std::pair<double, std::vector<Triangle>>> walls;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const RegionPair pair = film.regions(t);
    if ((pair.front == body) == (pair.behind == body)) continue;
    auto& [area, facets] = walls[pair.front == body ? pair.behind : pair.front];
    area += area_of(film, t);
    facets.push_back(t);
  }
  if (walls.empty()) return {};
  auto best = walls.begin();
  if (!best->first.outside()) {
    best = std::max_element(walls.begin(), walls.end(),
                            [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
  }
  if (any_fixed(film, best->second.second)) return {};
  const Region into = best->first;
  Event event{EventKind::burst, middle_of(film, best->second.second), {into, body}};
  replace(scene.film, {best->second.second, {}});
  join_regions(scene, into, body);
  return event;
}

}  // namespace lamella::surgery
