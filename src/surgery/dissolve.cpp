#include "surgery/dissolve.h"

namespace lamella::surgery {

using film::Film;
using film::Region;
using film::RegionPair;
using film::Triangle;

bool dissolve(scene::Scene& scene, film::Vertex v) {
  if (!scene.film.alive(v) || scene.film.first_end(v).valid()) return false;
  scene.film.remove(v);
  return true;
}

bool dissolve(scene::Scene& scene, film::Edge e) {
  if (!scene.film.alive(e) || scene.film.first_side(e).valid()) return false;
  scene.film.remove(e);
  return true;
}

bool dissolve(scene::Scene& scene, Triangle t) {
  if (!scene.film.alive(t)) return false;
  const RegionPair pair = scene.film.regions(t);
  if (pair.front != pair.behind && !pair.front.outside() && !pair.behind.outside()) return false;
  scene.film.remove(t);
  return true;
}

bool dissolve(scene::Scene& scene, Region body) {
  if (body.outside() || body.index > scene.bodies.size() || scene.body(body).absent) return false;
  Film& film = scene.film;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    RegionPair pair = film.regions(t);
    if (pair.front != body && pair.behind != body) continue;
    if (pair.front == body) pair.front = film::outside_region;
    if (pair.behind == body) pair.behind = film::outside_region;
    film.set_regions(t, pair);
  }
  scene.body(body).absent = true;
  return true;
}

}  // namespace lamella::surgery
