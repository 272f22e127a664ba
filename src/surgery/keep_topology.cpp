#include "surgery/keep_topology.h"

#include <algorithm>

#include "surgery/contract.h"
#include "surgery/link.h"
#include "surgery/merge.h"
#include "surgery/patch.h"
#include "surgery/pop.h"
#include "surgery/regions.h"
#include "surgery/sizing.h"
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
constexpr int most_refusals = 6;
constexpr int rounds_after_changes = 1;  // of the mesh

class Keeper {
 public:
  Keeper(Scene& scene, const TopologyOptions& options)
      : scene_(scene), film_(scene.film), options_(options) {}

  TopologyReport run(std::span<const Contact> contacts) {
    close_wedges();
    merge_contacts(contacts);
    add(remesh(scene_, options_.mesh));
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
};

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
  refuse_wedges();
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
    if (const auto done = contract(scene_, cluster, {.size = size, .gain = options_.gain})) note(*done);
  }
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
    if (const auto done =
            contract(scene_, std::span(&v, 1), {.size = size_of(film_, v), .gain = 0.01 * options_.gain}))
      note(*done);
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
  add(remesh(scene_, once));
}

}  // namespace

bool needs_look(const Film& film, const TopologyOptions& options) {
  if (needs_remesh(film, film.positions(), options.mesh)) return true;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    if (narrowest_wedge(film, Edge(i)) < options.narrow_wedge) return true;
  }
  return false;
}

TopologyReport keep_topology(Scene& scene, const TopologyOptions& options,
                             std::span<const Contact> contacts) {
  return Keeper(scene, options).run(contacts);
}

}  // namespace lamella::surgery
