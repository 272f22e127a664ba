#include "surgery/pop.h"

#include <algorithm>
#include <deque>

#include "surgery/contract.h"
#include "surgery/patch.h"
#include "surgery/split_edge.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Vertex;
using scene::Scene;

namespace {

// Every start may lead to so many commits, on average.
constexpr std::size_t commits_per_start = 4;

bool is_illegal(const Scene& scene, Vertex v) {
  if (!scene.film.alive(v) || !is_free(scene, v)) return false;
  const Link link = link_of(scene.film, v);
  return !link.nodes.empty() && kind_of(link) == LinkKind::illegal;
}

}  // namespace

std::vector<Edge> crowded_edges(const Film& film) {
  std::vector<Edge> edges;
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    if (film.alive(Edge(e)) && film.valence(Edge(e)) > 3) edges.emplace_back(e);
  }
  return edges;
}

double size_at(const Film& film, Vertex v) {
  double sum = 0;
  int count = 0;
  film.for_each_end(v, [&](EdgeEnd end) {
    sum += length(film.vector(end.outward()));
    ++count;
  });
  return count > 0 ? sum / count : 0;
}

std::vector<Vertex> illegal_vertices(const Scene& scene) {
  std::vector<Vertex> found;
  for (std::uint32_t i = 0; i < scene.film.vertex_rows(); ++i) {
    if (is_illegal(scene, Vertex(i))) found.emplace_back(i);
  }
  return found;
}

PopReport pop_vertices(Scene& scene, std::span<const Vertex> vertices, double gain) {
  PopReport report;
  Film& film = scene.film;
  const auto crowded = static_cast<long>(crowded_edges(film).size());
  std::deque<Vertex> waiting(vertices.begin(), vertices.end());
  std::size_t commits_left = commits_per_start * (waiting.size() + film.vertex_count() / 16 + 4);
  while (!waiting.empty() && commits_left > 0) {
    const Vertex v = waiting.front();
    waiting.pop_front();
    if (!is_illegal(scene, v)) continue;
    const auto done = contract(scene, std::span(&v, 1), {.size = size_at(film, v), .gain = gain});
    if (!done) continue;
    --commits_left;
    ++report.vertices;
    report.events.push_back(done->event);
    for (const Vertex made : done->made) {
      waiting.push_back(made);
      film.for_each_end(made, [&](EdgeEnd end) { waiting.push_back(film.head(end.outward())); });
    }
  }
  report.edges = std::max(0L, crowded - static_cast<long>(crowded_edges(film).size()));
  return report;
}

PopReport pop_edges(Scene& scene, std::span<const Edge> edges, double gain) {
  std::vector<Vertex> starts;
  for (const Edge e : edges) {
    Film& film = scene.film;
    if (!film.alive(e) || film.valence(e) < 4 || is_fixed(film, film::ElementKind::edge, e.index)) continue;
    const auto [tail, head] = film.ends(e);
    for (const Vertex v : {tail, head}) {
      if (is_free(scene, v)) starts.push_back(v);
    }
    if (!is_free(scene, tail) && !is_free(scene, head)) starts.push_back(split_edge(film, e));
  }
  return pop_vertices(scene, starts, gain);
}

}  // namespace lamella::surgery
