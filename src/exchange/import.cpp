#include "exchange/import.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "exchange/cells.h"
#include "exchange/weld.h"
#include "film/check.h"
#include "text/error.h"

namespace lamella::exchange {

namespace {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Region;
using film::RegionPair;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;

// Edges by their ends.
class FilmBuilder {
 public:
  Film build(const Welded& welded) {
    film_.reserve(welded.points.size(), 3 * welded.triangles.size() / 2, welded.triangles.size());
    for (const Vec3& p : welded.points) film_.add_vertex(p);
    for (std::size_t i = 0; i < welded.triangles.size(); ++i) {
      const auto& [a, b, c] = welded.triangles[i];
      film_.add_triangle({edge(a, b), edge(b, c), edge(c, a)},
                         welded.regions.empty() ? RegionPair{} : welded.regions[i]);
    }
    for (const auto& [a, b] : welded.wires) edge(a, b);
    film_.sort_all_sides();
    return std::move(film_);
  }

 private:
  SignedEdge edge(std::uint32_t a, std::uint32_t b) {
    const auto [at, made] = edges_.try_emplace(std::minmax(a, b));
    if (made) at->second = film_.add_edge(Vertex(a), Vertex(b));
    return SignedEdge(at->second, film_.ends(at->second)[0] != Vertex(a));
  }

  Film film_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Edge> edges_;
};

void turn(Welded& welded, std::size_t t) {
  std::swap(welded.triangles[t][1], welded.triangles[t][2]);
  welded.regions[t] = welded.regions[t].flipped();
}

// Open films by their neighbours: from one facet to the next across edges that only these two share.
void agree_with_neighbours(Welded& welded, const Film& film) {
  std::vector<std::uint8_t> done(welded.triangles.size(), 0);
  std::vector<std::uint8_t> turned(welded.triangles.size(), 0);
  const auto open = [&](std::uint32_t t) { return welded.regions[t].front == welded.regions[t].behind; };
  for (std::uint32_t first = 0; first < welded.triangles.size(); ++first) {
    if (done[first] != 0 || !open(first)) continue;
    std::vector<std::uint32_t> waiting = {first};
    done[first] = 1;
    while (!waiting.empty()) {
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      for (int k = 0; k < 3; ++k) {
        const film::Side side(Triangle(t), k);
        const film::Side other = film.next_around(side);
        const std::uint32_t next = other.triangle().index;
        if (next == t || film.next_around(other) != side || done[next] != 0 || !open(next)) continue;
        const bool alike = film.edge_of(side).reversed() != film.edge_of(other).reversed();
        turned[next] = alike ? turned[t] : static_cast<std::uint8_t>(1 - turned[t]);
        done[next] = 1;
        waiting.push_back(next);
      }
    }
  }
  for (std::uint32_t t = 0; t < turned.size(); ++t) {
    if (turned[t] != 0) turn(welded, t);
  }
}

Film oriented_film(Welded& welded) {
  const Film first = FilmBuilder().build(welded);
  agree_with_neighbours(welded, first);
  for (std::size_t t = 0; t < welded.triangles.size(); ++t) {
    if (welded.regions[t].front.index > welded.regions[t].behind.index) turn(welded, t);
  }
  return FilmBuilder().build(welded);
}

void add_bodies(scene::Scene& scene) {
  const Film& film = scene.film;
  std::vector<double> volumes(1, 0.0);
  std::vector<std::uint8_t> bounded(1, 0);
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const RegionPair pair = film.regions(Triangle(i));
    const std::array<Vec3, 3> p = film.points(Triangle(i));
    const double volume = dot(p[0], cross(p[1], p[2])) / 6;
    const std::size_t most = std::max(pair.front.index, pair.behind.index);
    if (most >= volumes.size()) {
      volumes.resize(most + 1, 0.0);
      bounded.resize(most + 1, 0);
    }
    volumes[pair.behind.index] += volume;
    volumes[pair.front.index] -= volume;
    if (pair.front != pair.behind) bounded[pair.front.index] = bounded[pair.behind.index] = 1;
  }
  for (std::size_t b = 1; b < volumes.size(); ++b) {
    scene::Body body;
    body.original = static_cast<std::uint32_t>(b);
    body.absent = bounded[b] == 0;
    if (!body.absent) body.target_volume = volumes[b];
    scene.bodies.push_back(body);
  }
  scene.body_columns.resize(scene.bodies.size());
}

film::Column fixed_column(ElementKind kind) {
  return datafile::make_column(*datafile::known_column(kind, "fixed"));
}

// Wires, and rims unless they are to be free.
std::size_t fix_wires(Film& film, const Welded& welded, bool free_rims) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, WireKind> drawn;
  for (std::size_t i = 0; i < welded.wires.size(); ++i)
    drawn[std::minmax(welded.wires[i][0], welded.wires[i][1])] = welded.wire_kinds[i];
  std::vector<Edge> fixed;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const auto& [a, b] = film.ends(Edge(i));
    const int sides = film.valence(Edge(i));
    const auto at = drawn.find(std::minmax(a.index, b.index));
    const bool wire = at != drawn.end() && at->second == WireKind::wire;
    const bool known_rim = at != drawn.end() && !wire;
    if (sides == 0 || wire || (sides == 1 && !free_rims && !known_rim)) fixed.push_back(Edge(i));
  }
  if (fixed.empty()) return 0;
  film::Column& edges = film.columns(ElementKind::edge).add(fixed_column(ElementKind::edge));
  film::Column& vertices = film.columns(ElementKind::vertex).add(fixed_column(ElementKind::vertex));
  for (const Edge e : fixed) {
    edges.set(e.index, 0, 1);
    for (const Vertex v : film.ends(e)) vertices.set(v.index, 0, 1);
  }
  return fixed.size();
}

double tolerance_for(const Soup& soup, const std::optional<double>& given) {
  constexpr double part = 1e-6;
  return given ? *given : part * diagonal(soup.points);
}

void set_regions(Welded& welded, Imported& imported) {
  if (!welded.regions.empty()) return;
  imported.found_regions = true;
  Cells cells = find_cells(FilmBuilder().build(welded));
  welded.regions = std::move(cells.regions);
}

}  // namespace

Imported import_scene(const std::string& path, const ImportOptions& options) {
  Soup soup = read_soup(path);
  if (options.labels) soup.regions = read_labels(*options.labels, soup.size());
  Imported imported;
  imported.tolerance = tolerance_for(soup, options.tolerance);
  if (!std::isfinite(imported.tolerance)) throw text::Error("the mesh is too large to be imported");
  Welded welded = weld(soup, imported.tolerance);
  if (welded.triangles.empty() && welded.wires.empty())
    throw text::Error(fmt::format("there is no facet in \"{}\"", path));
  imported.merged_points = welded.merged_points;
  imported.dropped = welded.dropped;
  imported.duplicates = welded.duplicates;
  set_regions(welded, imported);
  scene::Scene& scene = imported.scene;
  scene.film = oriented_film(welded);
  scene.name = path;
  add_bodies(scene);
  imported.fixed_edges = fix_wires(scene.film, welded, options.free_rims);
  for (const std::string& finding : film::check_regions(scene.film, 3)) imported.warnings.push_back(finding);
  return imported;
}

}  // namespace lamella::exchange
