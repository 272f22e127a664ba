#include "surgery/link.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace lamella::surgery {

using film::EdgeEnd;
using film::Film;
using film::Region;
using film::Side;
using film::Triangle;
using film::Vertex;

namespace {

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int a, int b) { at(find(a)) = find(b); }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

// A place in the ring of one outgoing edge.
struct Slot {
  int edge = 0;
  int place = 0;
};

class LinkMaker {
 public:
  LinkMaker(const Film& film, std::span<const Vertex> cluster) : film_(film), cluster_(cluster) {}

  Link make() {
    collect();
    trace_nodes();
    if (link_.sound) trace_sectors();
    return std::move(link_);
  }

 private:
  bool contains(Vertex v) const { return std::find(cluster_.begin(), cluster_.end(), v) != cluster_.end(); }
  void collect();
  void collect_ring(EdgeEnd end);
  int arc_of(Triangle t);
  bool vanishes(Triangle t) const;
  Side other_outgoing(Side s) const;
  Slot next(Slot slot) const {
    const auto& ring = rings_[Link::index(slot.edge)];
    return {slot.edge, (slot.place + 1) % static_cast<int>(ring.size())};
  }
  Side at(Slot slot) const { return rings_[Link::index(slot.edge)][Link::index(slot.place)]; }
  void trace_nodes();
  void trace_node(Slot start);
  void trace_sectors();
  Region label(int face) const;

  const Film& film_;
  std::span<const Vertex> cluster_;
  Link link_;
  std::vector<std::vector<Side>> rings_;  // of outgoing edges, counterclockwise about the way out
  std::vector<Vertex> outer_;
  std::unordered_map<std::uint32_t, Slot> slot_of_;
  std::unordered_map<std::uint32_t, int> arc_of_;
  std::unordered_map<std::uint32_t, bool> met_;
};

void LinkMaker::collect_ring(EdgeEnd end) {
  std::vector<Side> ring;
  film_.for_each_side(end.edge(), [&](Side s) { ring.push_back(s); });
  if (ring.empty()) {
    link_.has_wires = true;
    return;
  }
  if (end.end() == 1) std::reverse(ring.begin(), ring.end());
  const int edge = static_cast<int>(rings_.size());
  for (std::size_t i = 0; i < ring.size(); ++i) slot_of_[ring[i].index] = {edge, static_cast<int>(i)};
  rings_.push_back(std::move(ring));
  outer_.push_back(film_.head(end.outward()));
}

void LinkMaker::collect() {
  for (const Vertex v : cluster_) {
    film_.for_each_end(v, [&](EdgeEnd end) {
      if (!contains(film_.head(end.outward()))) {
        collect_ring(end);
        return;
      }
      film_.for_each_side(end.edge(), [&](Side s) {
        if (std::find(link_.inside.begin(), link_.inside.end(), s.triangle()) == link_.inside.end())
          link_.inside.push_back(s.triangle());
      });
    });
  }
}

bool LinkMaker::vanishes(Triangle t) const {
  int inside = 0;
  for (const Vertex v : film_.corners(t)) inside += contains(v) ? 1 : 0;
  return inside > 1;
}

// The other side, from the cluster outward, of a facet with two corners in it.
Side LinkMaker::other_outgoing(Side s) const {
  for (int k = 0; k < 3; ++k) {
    const Side other(s.triangle(), k);
    if (other != s && slot_of_.contains(other.index)) return other;
  }
  return {};
}

int LinkMaker::arc_of(Triangle t) {
  const auto [found, added] = arc_of_.try_emplace(t.index, static_cast<int>(link_.arcs.size()));
  if (added) {
    const auto& corners = film_.corners(t);
    const auto at = std::find_if(corners.begin(), corners.end(), [&](Vertex v) { return contains(v); });
    link_.arcs.push_back({t, *at, {-1, -1}, 0, 0});
  }
  return found->second;
}

void LinkMaker::trace_node(Slot start) {
  Link::Node node;
  node.outer = outer_[Link::index(start.edge)];
  const int index = static_cast<int>(link_.nodes.size());
  const std::size_t most = slot_of_.size() + 1;
  Slot slot = start;
  for (std::size_t steps = 0; steps <= most; ++steps) {
    const Side s = at(slot);
    if (vanishes(s.triangle())) {
      const Side other = other_outgoing(s);
      if (!other.valid()) break;
      slot = next(slot_of_.at(other.index));
      continue;
    }
    if (met_[s.index]) {
      link_.nodes.push_back(std::move(node));
      return;
    }
    met_[s.index] = true;
    const int arc = arc_of(s.triangle());
    const bool leaves =
        film_.corners(s.triangle())[Link::index(s.corner())] == link_.arcs[Link::index(arc)].at;
    const int end = leaves ? 0 : 1;
    link_.arcs[Link::index(arc)].node[Link::index(end)] = index;
    node.ends.push_back({arc, end});
    slot = next(slot);
  }
  link_.sound = false;
}

void LinkMaker::trace_nodes() {
  for (int edge = 0; edge < static_cast<int>(rings_.size()); ++edge) {
    for (int place = 0; place < static_cast<int>(rings_[Link::index(edge)].size()); ++place) {
      const Side s = at({edge, place});
      if (!vanishes(s.triangle()) && !met_[s.index] && link_.sound) trace_node({edge, place});
    }
  }
}

Region LinkMaker::label(int face) const {
  const film::RegionPair pair = film_.regions(link_.arcs[Link::index(face / 2)].facet);
  return face % 2 == 0 ? pair.front : pair.behind;
}

// Faces of arcs, 2a in front and 2a + 1 behind, are of one sector where they follow one another around a
// node.
void LinkMaker::trace_sectors() {
  const std::size_t arcs = link_.arcs.size();
  for (std::size_t a = 0; a < arcs; ++a) {
    link_.arcs[a].front = static_cast<int>(2 * a);
    link_.arcs[a].behind = static_cast<int>(2 * a + 1);
  }
  Sets faces(2 * arcs);
  Sets nodes(link_.nodes.size());
  for (const Link::Node& node : link_.nodes) {
    for (std::size_t i = 0; i < node.ends.size(); ++i)
      faces.join(link_.after(node.ends[i]), link_.before(node.ends[(i + 1) % node.ends.size()]));
  }
  std::vector<int> number(2 * arcs, -1);
  const auto sector_of = [&](int face) {
    int& sector = number[Link::index(faces.find(face))];
    if (sector < 0) {
      sector = static_cast<int>(link_.sectors.size());
      link_.sectors.push_back({label(face), {}});
    }
    Link::Sector& found = link_.sectors[Link::index(sector)];
    if (found.region != label(face)) link_.sound = false;
    if (found.arcs.empty() || found.arcs.back() != face / 2) found.arcs.push_back(face / 2);
    return sector;
  };
  for (Link::Arc& arc : link_.arcs) {
    if (arc.node[0] < 0 || arc.node[1] < 0) {
      link_.sound = false;
      return;
    }
    arc.front = sector_of(arc.front);
    arc.behind = sector_of(arc.behind);
    nodes.join(arc.node[0], arc.node[1]);
  }
  std::vector<int> component(link_.nodes.size(), -1);
  for (std::size_t n = 0; n < link_.nodes.size(); ++n) {
    int& at = component[Link::index(nodes.find(static_cast<int>(n)))];
    if (at < 0) at = link_.components++;
    link_.nodes[n].component = at;
  }
}

// The pairs of sectors that the chains of arcs between nodes of three part, sorted. Empty where a chain
// closes on itself or has one sector on both sides.
std::vector<std::pair<int, int>> chain_sectors(const Link& link) {
  std::vector<std::pair<int, int>> pairs;
  for (const Link::Node& node : link.nodes) {
    if (node.degree() != 3) continue;
    for (const Link::ArcEnd end : node.ends) {
      const Link::Arc& arc = link.arcs[Link::index(end.arc)];
      if (arc.front == arc.behind) return {};
      pairs.push_back(std::minmax(arc.front, arc.behind));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

Link link_of(const Film& film, std::span<const Vertex> cluster) {
  return LinkMaker(film, cluster).make();
}

Link link_of(const Film& film, Vertex v) {
  return link_of(film, std::span(&v, 1));
}

LinkKind kind_of(const Link& link) {
  if (link.nodes.empty()) return LinkKind::empty;
  if (!link.sound || link.components != 1 || link.has_wires) return LinkKind::illegal;
  int ends = 0;
  int triples = 0;
  for (const Link::Node& node : link.nodes) {
    if (node.degree() > 3) return LinkKind::illegal;
    ends += node.degree() == 1 ? 1 : 0;
    triples += node.degree() == 3 ? 1 : 0;
  }
  if (ends > 0) return ends == 2 && triples == 0 ? LinkKind::rim : LinkKind::illegal;
  if (triples == 0) return LinkKind::disc;
  // Each chain is met from both its ends: three chains between two nodes, six between four, all of them
  // parting different sectors.
  std::vector<std::pair<int, int>> pairs = chain_sectors(link);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  if (triples == 2 && pairs.size() == 3) return LinkKind::triple;
  if (triples == 4 && pairs.size() == 6 && link.sectors.size() == 4) return LinkKind::tetrahedral;
  return LinkKind::illegal;
}

}  // namespace lamella::surgery
