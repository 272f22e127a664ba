#include "surgery/rearrangement.h"

#include <algorithm>

namespace lamella::surgery {

using film::Region;
using film::RegionPair;

namespace {

using ArcEnd = Link::ArcEnd;

constexpr auto at = &Link::index;

// A place on the border of a sector: it lies between two arcs at a node, counterclockwise after the first.
struct Turn {
  int node = 0;
  ArcEnd first;
  ArcEnd second;
};

bool has_film(Region a, Region b) {
  return a != b || a.outside();
}

std::vector<Turn> turns_of(const Link& link, int sector) {
  std::vector<Turn> turns;
  for (std::size_t n = 0; n < link.nodes.size(); ++n) {
    const auto& ends = link.nodes[n].ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (link.after(ends[i]) == sector)
        turns.push_back({static_cast<int>(n), ends[i], ends[(i + 1) % ends.size()]});
    }
  }
  return turns;
}

bool visits_twice(const std::vector<Turn>& turns) {
  std::vector<int> nodes;
  for (const Turn& turn : turns) nodes.push_back(turn.node);
  std::sort(nodes.begin(), nodes.end());
  return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
}

// The border of a sector walked with the sector on the right, from turn to turn; empty where it falls into
// several pieces or meets a node twice.
std::vector<Turn> walk_around(const Link& link, int sector) {
  const std::vector<Turn> turns = turns_of(link, sector);
  if (turns.empty() || visits_twice(turns)) return {};
  std::vector<Turn> walk{turns[0]};
  while (walk.size() <= turns.size()) {
    const ArcEnd along = walk.back().second;
    const int to = link.arcs[at(along.arc)].node[at(1 - along.end)];
    const auto next =
        std::find_if(turns.begin(), turns.end(), [&](const Turn& turn) { return turn.node == to; });
    if (next == turns.end() || next->first.arc != along.arc) return {};
    if (next->node == walk[0].node) break;
    walk.push_back(*next);
  }
  return walk.size() == turns.size() ? walk : std::vector<Turn>{};
}

Region region(const Link& link, int sector) {
  return link.sectors[at(sector)].region;
}

bool borders_itself(const Link& link, int sector) {
  return std::any_of(link.sectors[at(sector)].arcs.begin(), link.sectors[at(sector)].arcs.end(),
                     [&](int a) { return link.arcs[at(a)].front == link.arcs[at(a)].behind; });
}

// The arcs around a sector go to copy 0, the others to copy 1; where others end between two of them a film
// joins the copies.
void add_part(const Link& link, int sector, std::vector<Rearrangement>& list) {
  if (borders_itself(link, sector)) return;
  const std::vector<Turn> turns = walk_around(link, sector);
  if (turns.empty()) return;
  Rearrangement r{Move::part, 2, std::vector<int>(link.arcs.size(), 1), {}};
  for (const Turn& turn : turns) r.copy_of_arc[at(turn.second.arc)] = 0;
  bool crossed = false;
  for (const Turn& turn : turns) {
    if (link.nodes[at(turn.node)].degree() < 3) continue;
    crossed = true;
    const int x = link.before(turn.first);
    const int y = link.after(turn.second);
    if (!has_film(region(link, x), region(link, y))) continue;
    r.films.push_back({{{{0, -1}, {-1, turn.node}, {1, -1}}},
                       {region(link, x), region(link, y)},
                       link.arcs[at(turn.first.arc)].facet});
  }
  const bool all = std::all_of(r.copy_of_arc.begin(), r.copy_of_arc.end(), [](int c) { return c == 0; });
  if (crossed && !all) list.push_back(std::move(r));
}

void add_apart(const Link& link, std::vector<Rearrangement>& list) {
  if (link.components < 2) return;
  Rearrangement r{Move::apart, link.components, std::vector<int>(link.arcs.size()), {}};
  for (std::size_t a = 0; a < link.arcs.size(); ++a)
    r.copy_of_arc[a] = link.nodes[at(link.arcs[a].node[0])].component;
  list.push_back(std::move(r));
}

// What two sectors need to be joined: borders without a common node, and between these nothing but strands of
// arcs, each from one node of three of the one to one of the other.
class Joiner {
 public:
  Joiner(const Link& link, int a, int b) : link_(link), a_(a), b_(b) {}

  bool make(Rearrangement& r) {
    walk_a_ = walk_around(link_, a_);
    walk_b_ = walk_around(link_, b_);
    if (walk_a_.empty() || walk_b_.empty() || !mark_borders() || !trace_strands()) return false;
    r = {Move::join, strands_ + (strands_ > 3 ? 1 : 0), strand_of_arc_, {}};
    if (!go_around(walk_a_, a_, 1, r) || !go_around(walk_b_, b_, -1, r)) return false;
    add_face(r);
    return true;
  }

 private:
  bool mark_borders();
  bool trace_strands();
  bool go_around(const std::vector<Turn>& walk, int sector, int step, Rearrangement& r) const;
  void add_chain(std::span<const Turn> chain, int sector, int from, int to, Rearrangement& r) const;
  void add_face(Rearrangement& r) const;

  const Link& link_;
  int a_;
  int b_;
  std::vector<Turn> walk_a_;
  std::vector<Turn> walk_b_;
  std::vector<int> side_of_node_;   // 1 on the border of a, 2 of b, 0 on neither
  std::vector<int> strand_of_arc_;  // -1 for arcs on borders
  std::vector<int> strand_of_node_;
  int strands_ = 0;
};

bool Joiner::mark_borders() {
  side_of_node_.assign(link_.nodes.size(), 0);
  for (const Turn& turn : walk_a_) side_of_node_[at(turn.node)] = 1;
  for (const Turn& turn : walk_b_) {
    if (side_of_node_[at(turn.node)] != 0) return false;
    side_of_node_[at(turn.node)] = 2;
  }
  for (std::size_t n = 0; n < link_.nodes.size(); ++n) {
    const int degree = link_.nodes[n].degree();
    if (side_of_node_[n] == 0 ? degree != 2 : degree > 3) return false;
  }
  return true;
}

// Follows each arc that leaves the border of a until it meets that of b.
bool Joiner::trace_strands() {
  strand_of_arc_.assign(link_.arcs.size(), -1);
  strand_of_node_.assign(link_.nodes.size(), -1);
  std::size_t used = walk_a_.size() + walk_b_.size();
  for (const Turn& turn : walk_a_) {
    const auto& node = link_.nodes[at(turn.node)];
    if (node.degree() != 3) continue;
    ArcEnd leaving;
    for (const ArcEnd& end : node.ends) {
      if (end.arc != turn.first.arc && end.arc != turn.second.arc) leaving = end;
    }
    strand_of_node_[at(turn.node)] = strands_;
    for (std::size_t steps = 0; steps <= link_.arcs.size(); ++steps) {
      strand_of_arc_[at(leaving.arc)] = strands_;
      ++used;
      const int to = link_.arcs[at(leaving.arc)].node[at(1 - leaving.end)];
      if (side_of_node_[at(to)] == 1) return false;
      if (side_of_node_[at(to)] == 2) {
        strand_of_node_[at(to)] = strands_;
        break;
      }
      const auto& ends = link_.nodes[at(to)].ends;
      leaving = ends[0].arc == leaving.arc ? ends[1] : ends[0];
    }
    ++strands_;
  }
  return strands_ >= 3 && used == link_.arcs.size();
}

// The films of a border between two strands hang on the copies of both, and a piece spans from copy to copy.
void Joiner::add_chain(std::span<const Turn> chain, int sector, int from, int to, Rearrangement& r) const {
  const std::size_t half = (chain.size() + 1) / 2;
  for (std::size_t i = 0; i < chain.size(); ++i)
    r.copy_of_arc[at(chain[i].second.arc)] = i < half ? from : to;
  const ArcEnd last = chain[half - 1].second;
  const Link::Arc& arc = link_.arcs[at(last.arc)];
  const int other = arc.front == sector ? arc.behind : arc.front;
  r.films.push_back({{{{from, -1}, {-1, arc.node[at(1 - last.end)]}, {to, -1}}},
                     {region(link_, other), region(link_, sector)},
                     arc.facet});
}

bool Joiner::go_around(const std::vector<Turn>& walk, int sector, int step, Rearrangement& r) const {
  const auto strand = [&](std::size_t i) { return strand_of_node_[at(walk[i % walk.size()].node)]; };
  std::size_t first = 0;
  while (first < walk.size() && strand(first) < 0) ++first;
  std::vector<Turn> chain;
  for (std::size_t i = first; i < first + walk.size(); ++i) {
    if (i == first || strand(i) < 0) {
      chain.push_back(walk[i % walk.size()]);
      continue;
    }
    const int from = strand_of_node_[at(chain[0].node)];
    if ((from + step + strands_) % strands_ != strand(i)) return false;
    add_chain(chain, sector, from, strand(i), r);
    chain.assign(1, walk[i % walk.size()]);
  }
  const int from = strand_of_node_[at(chain[0].node)];
  if ((from + step + strands_) % strands_ != strand(first)) return false;
  add_chain(chain, sector, from, strand(first), r);
  return true;
}

// Seen along the walk around a, with a on the right, the face turns its front to b.
void Joiner::add_face(Rearrangement& r) const {
  const RegionPair regions{region(link_, b_), region(link_, a_)};
  if (!has_film(regions.front, regions.behind)) return;
  const film::Triangle like = link_.arcs[at(walk_a_[0].second.arc)].facet;
  if (strands_ == 3) {
    r.films.push_back({{{{0, -1}, {1, -1}, {2, -1}}}, regions, like});
    return;
  }
  for (int i = 0; i < strands_; ++i)
    r.films.push_back({{{{i, -1}, {(i + 1) % strands_, -1}, {strands_, -1}}}, regions, like});
}

}  // namespace

std::vector<Rearrangement> rearrangements(const Link& link) {
  std::vector<Rearrangement> list;
  list.push_back({Move::keep, 1, std::vector<int>(link.arcs.size(), 0), {}});
  add_apart(link, list);
  const int sectors = static_cast<int>(link.sectors.size());
  for (int a = 0; a < sectors; ++a) {
    add_part(link, a, list);
    for (int b = 0; b < a; ++b) {
      Rearrangement r;
      if (Joiner(link, a, b).make(r)) list.push_back(std::move(r));
    }
  }
  return list;
}

}  // namespace lamella::surgery
