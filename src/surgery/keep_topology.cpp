#include "surgery/keep_topology.h"

#include <algorithm>

#include "surgery/contract.h"
#include "surgery/link.h"
#include "surgery/merge.h"
#include "surgery/patch.h"
#include "surgery/pop.h"
#include "surgery/regions.h"
#include "surgery/sizing.h"
#include "surgery/vanish.h"
#include "surgery/wedge.h"
#include "surgery/zip.h"

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Vertex;
using scene::Scene;

namespace {

constexpr int most_commits = 64;  // of a pass
constexpr int most_merges = 4;
constexpr std::size_t most_in_cluster = 12;
constexpr int most_refusals = 6;
constexpr int rounds_after_changes = 1;  // of the mesh
constexpr double very_near = 0.1;        // in sizes: what is so near a cluster comes together with it
constexpr double far_out = 1.5;          // of the band, in its bounds: this cannot wait

// A cluster with what is joined to it by next to nothing: another corner of a film that has shrunk to a
// point, which would leave a change of topology no room.
std::vector<Vertex> whole_cluster(const Scene& scene, std::span<const Vertex> part, double size) {
  std::vector<Vertex> cluster(part.begin(), part.end());
  for (std::size_t i = 0; i < cluster.size() && cluster.size() <= most_in_cluster; ++i) {
    scene.film.for_each_end(cluster[i], [&](film::EdgeEnd end) {
      const Vertex v = scene.film.head(end.outward());
      const bool near = length(scene.film.vector(end.outward())) < very_near * size;
      if (near && is_free(scene, v) && std::find(cluster.begin(), cluster.end(), v) == cluster.end())
        cluster.push_back(v);
    });
  }
  return cluster;
}

// Free vertices where lines meet as they do in no film: an edge of more than three films, or ends of lines
// whose link is illegal.
std::vector<Vertex> places_to_pop(const Scene& scene) {
  const Film& film = scene.film;
  struct Lines {
    int count = 0;
    int least = 0;
    int most = 0;
  };
  std::vector<Lines> lines(film.vertex_rows());
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const int valence = film.alive(Edge(i)) ? film.valence(Edge(i)) : 2;
    if (valence == 2) continue;
    for (const Vertex v : film.ends(Edge(i))) {
      Lines& at = lines[v.index];
      at.least = at.count == 0 ? valence : std::min(at.least, valence);
      at.most = std::max(at.most, valence);
      ++at.count;
    }
  }
  std::vector<Vertex> found;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const Lines& at = lines[i];
    const Vertex v(i);
    const bool plain = at.count == 0 || (at.count == 2 && at.least == at.most && at.most <= 3);
    if (!plain && is_free(scene, v) && kind_of(link_of(film, v)) == LinkKind::illegal) found.push_back(v);
  }
  return found;
}

class Keeper {
 public:
  Keeper(Scene& scene, const TopologyOptions& options)
      : scene_(scene), film_(scene.film), options_(options) {}

  TopologyReport run(std::span<const Contact> contacts) {
    if (options_.changes) {
      vanish();
      close_wedges();
    }
    refuse_wedges();
    merge_contacts(contacts);
    if (options_.upkeep) add(remesh(scene_, options_.mesh));
    if (options_.changes) resolve(report_.mesh.stuck);
    if (!report_.events.empty()) finish();
    return std::move(report_);
  }

 private:
  void add(RemeshReport more) {
    report_.touched.insert(report_.touched.end(), more.touched.begin(), more.touched.end());
    RemeshReport& all = report_.mesh;
    all.splits += more.splits;
    all.collapses += more.collapses;
    all.flips += more.flips;
    all.moved += more.moved;
    all.stuck = std::move(more.stuck);
  }
  void vanish();
  void close_wedges();
  void refuse_wedges();
  void merge_contacts(std::span<const Contact> contacts);
  void resolve(const std::vector<std::vector<Vertex>>& clusters);
  void note(const Contraction& done);
  void pop_around();
  void finish();

  Scene& scene_;
  Film& film_;
  TopologyOptions options_;
  TopologyReport report_;
  std::vector<Vertex> odd_;  // perhaps illegal
  int commits_ = 0;
  std::optional<film::CrossingGrid> grid_;  // of changes of topology
};

void Keeper::vanish() {
  Vanished done = vanish_small_parts(scene_);
  for (Event& event : done.events) report_.events.push_back(std::move(event));
  report_.touched.insert(report_.touched.end(), done.touched.begin(), done.touched.end());
  odd_.insert(odd_.end(), done.touched.begin(), done.touched.end());
}

// Narrowest first; each vertex once a pass.
void Keeper::close_wedges() {
  std::vector<std::pair<double, Edge>> narrow;
  for (std::uint32_t i = 0; i < film_.edge_rows(); ++i) {
    if (!film_.alive(Edge(i))) continue;
    const double angle = narrowest_wedge(film_, Edge(i));
    if (angle < options_.narrow_wedge) narrow.emplace_back(angle, Edge(i));
  }
  std::sort(narrow.begin(), narrow.end());
  for (const auto& [angle, edge] : narrow) {
    if (!film_.alive(edge)) continue;
    const std::array<Vertex, 2> ends = film_.ends(edge);  // a copy: zipping makes edges
    for (const Vertex v : ends) {
      if (narrowest_wedge(film_, edge) >= options_.narrow_wedge) break;
      const auto done = zip(scene_, v, size_of(film_, v));
      if (!done) continue;
      ++report_.zips;
      report_.touched.insert(report_.touched.end(), done->touched.begin(), done->touched.end());
    }
  }
}

// What stayed narrow must not close: its films are told of as contacts that could not be merged.
void Keeper::refuse_wedges() {
  for (std::uint32_t i = 0; i < film_.edge_rows(); ++i) {
    const Edge e(i);
    if (!film_.alive(e) || narrowest_wedge(film_, e) >= options_.narrow_wedge) continue;
    film_.for_each_side(e, [&](film::Side s) {
      const film::Side next = film_.next_around(s);
      for (const auto& [from, to] : {std::pair(s, next), std::pair(next, s)}) {
        const film::Vec3 p = film_.position(film_.opposite(from));
        const film::Vec3 place = nearest_point(film_.points(to.triangle()), p);
        const double distance = length(p - place);
        if (distance < 0.5 * length(p - film_.position(film_.ends(e)[0])))
          report_.refused.push_back({{film_.opposite(from), to.triangle()}, distance, place, true});
      }
    });
  }
}

// Nearest first. A merge moves the film around it, so that later contacts may be gone.
void Keeper::merge_contacts(std::span<const Contact> contacts) {
  int merges = 0;
  int refusals = 0;
  std::vector<film::Vec3> done_at;
  for (const Contact& contact : contacts) {
    if (!options_.changes || merges >= most_merges || refusals >= most_refusals) {
      report_.refused.push_back(contact);
      continue;
    }
    if (!film_.alive(contact.pair.vertex) || !film_.alive(contact.pair.facet)) continue;
    const double size = size_of(film_, contact.pair.vertex);
    // One merge takes all contacts around it.
    const bool taken = std::any_of(done_at.begin(), done_at.end(),
                                   [&](const film::Vec3& p) { return length(p - contact.place) < 4 * size; });
    if (taken) continue;
    if (auto done = merge(scene_, contact.pair, size)) {
      ++merges;
      done_at.push_back(contact.place);
      report_.events.push_back(done->event);
      report_.touched.insert(report_.touched.end(), done->touched.begin(), done->touched.end());
    } else {
      ++refusals;
      report_.refused.push_back(contact);
    }
  }
}

void Keeper::note(const Contraction& done) {
  ++commits_;
  report_.events.push_back(done.event);
  for (const Vertex v : done.made) {
    report_.touched.push_back(v);
    odd_.push_back(v);
    film_.for_each_end(v, [&](film::EdgeEnd end) {
      report_.touched.push_back(film_.head(end.outward()));
      odd_.push_back(film_.head(end.outward()));
    });
  }
}

void Keeper::resolve(const std::vector<std::vector<Vertex>>& clusters) {
  for (const std::vector<Vertex>& cluster : clusters) {
    if (commits_ >= most_commits) {
      report_.bounded = true;
      return;
    }
    if (!std::all_of(cluster.begin(), cluster.end(), [&](Vertex v) { return film_.alive(v); })) continue;
    const double size = size_of(film_, cluster[0]);
    const std::vector<Vertex> whole = whole_cluster(scene_, cluster, size);
    if (const auto done = contract(scene_, whole, {.size = size, .gain = options_.gain, .grid = &grid_}))
      note(*done);
  }
  for (const Vertex v : places_to_pop(scene_)) odd_.push_back(v);
  pop_around();
}

// What a change leaves around it may be no soap film yet.
void Keeper::pop_around() {
  for (std::size_t i = 0; i < odd_.size(); ++i) {
    if (commits_ >= most_commits) {
      report_.bounded = true;
      return;
    }
    const Vertex v = odd_[i];
    if (!film_.alive(v) || !is_free(scene_, v)) continue;
    const Link link = link_of(film_, v);
    if (link.nodes.empty() || kind_of(link) != LinkKind::illegal) continue;
    const ContractOptions how{.size = size_of(film_, v), .gain = 0.01 * options_.gain, .grid = &grid_};
    if (const auto done = contract(scene_, std::span(&v, 1), how)) note(*done);
  }
}

void Keeper::finish() {
  RemeshOptions once = options_.mesh;
  once.rounds = rounds_after_changes;
  std::vector<Vertex> vertices;
  for (const Vertex v : report_.touched) {
    if (film_.alive(v)) vertices.push_back(v);
  }
  settle_regions(scene_, report_.events, facets_at(film_, vertices));
  if (options_.upkeep || options_.tidy) add(remesh(scene_, once));
}

}  // namespace

bool needs_look(const Scene& scene, const TopologyOptions& options) {
  const Film& film = scene.film;
  return needs_remesh(film, film.positions(), options.mesh) || has_narrow_wedges(film, options) ||
         has_small_parts(scene) || !places_to_pop(scene).empty();
}

bool has_narrow_wedges(const Film& film, const TopologyOptions& options) {
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    if (narrowest_wedge(film, Edge(i)) < options.narrow_wedge) return true;
  }
  return false;
}

bool is_far_out_of_band(const Film& film, const TopologyOptions& options) {
  RemeshOptions far = options.mesh;
  far.longest *= far_out;
  far.shortest /= far_out;
  far.sliver /= far_out;
  return needs_remesh(film, film.positions(), far);
}

TopologyReport keep_topology(Scene& scene, const TopologyOptions& options,
                             std::span<const Contact> contacts) {
  return Keeper(scene, options).run(contacts);
}

}  // namespace lamella::surgery
