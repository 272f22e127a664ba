#include "datafile/body_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace lamella::datafile {

namespace {

using film::ElementKind;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;

constexpr std::uint32_t nobody = 0xffffffffU;

// How the faces of one body meet at an edge. An entry is the place of a face in the list of faces of all
// bodies.
struct Meeting {
  std::uint32_t body = nobody;  // whose faces these are
  std::uint32_t uses = 0;
  int sum = 0;  // of the directions in which the faces walk the edge; 0 in the boundary of a closed body
  std::uint32_t first = 0;  // the first two entries, and the direction of the first
  std::uint32_t second = 0;
};

class BodyCheck {
 public:
  BodyCheck(Reading& reading, const Resolved& resolved, const std::vector<film::Region>& regions)
      : reading_(reading),
        rows_(reading.rows),
        resolved_(resolved),
        regions_(regions),
        meetings_(resolved.edge_ends.size()),
        claims_(rows_.of(ElementKind::facet).size()) {}

  std::vector<film::RegionPair> run();

 private:
  // The entry that claimed each side of a face.
  struct Claims {
    std::uint32_t front = nobody;
    std::uint32_t behind = nobody;
  };
  struct Neighbour {
    std::uint32_t entry = 0;
    bool agrees = false;  // both are listed with their normals to the same side
  };
  struct Body {
    std::uint32_t row = 0;
    std::uint32_t begin = 0;  // its entries
    std::uint32_t end = 0;
  };

  std::int32_t signed_face(std::uint32_t entry) const { return rows_.body_faces.ids[entry]; }
  Triangle face(std::uint32_t entry) const { return resolved_.body_faces[entry]; }
  std::span<const SignedEdge> loop(Triangle face) const;
  text::Place entry_place(std::uint32_t entry) const {
    return reading_.tokens.place(rows_.body_faces.spots[entry]);
  }
  std::uint32_t body_id(std::uint32_t row) const { return rows_.of(ElementKind::body).ids[row]; }
  std::uint32_t face_id(Triangle t) const { return rows_.of(ElementKind::facet).ids[t.index]; }

  bool claim_sides(const Body& body);
  bool all_sound(const Body& body) const;
  void check_boundary(const Body& body);
  void collect_meetings(const Body& body);
  std::vector<std::vector<Neighbour>> neighbours(const Body& body) const;
  std::vector<std::uint32_t> turned_faces(const Body& body) const;
  void report_turned(const Body& body, const std::vector<std::uint32_t>& turned);
  void report_gap(const Body& body, film::Edge edge);
  bool is_inside_out(const Body& body) const;

  Reading& reading_;
  const Rows& rows_;
  const Resolved& resolved_;
  const std::vector<film::Region>& regions_;
  std::vector<Meeting> meetings_;       // by edge
  std::vector<film::Edge> touched_;     // the edges of the present body
  std::vector<Claims> claims_;          // by face
  std::vector<std::uint8_t> repeated_;  // by entry: its body has claimed this side already
  std::vector<std::uint32_t> owner_;    // by entry: the row of its body
};

std::span<const SignedEdge> BodyCheck::loop(Triangle t) const {
  return {resolved_.loops.data() + rows_.loops.begin(t.index), rows_.loops.size(t.index)};
}

// Whether no other body claims a side. What the body itself lists again does not count.
bool BodyCheck::claim_sides(const Body& body) {
  bool clean = true;
  for (std::uint32_t entry = body.begin; entry < body.end; ++entry) {
    const Triangle t = face(entry);
    if (!t.valid()) continue;
    const bool behind = signed_face(entry) > 0;
    std::uint32_t& claim = behind ? claims_[t.index].behind : claims_[t.index].front;
    if (claim == nobody) {
      claim = entry;
      continue;
    }
    const std::uint32_t other = owner_[claim];
    if (other == body.row) {
      repeated_[entry] = 1;
      reading_.findings.warning(entry_place(entry), fmt::format("face {} is listed twice in body {}",
                                                                face_id(t), body_id(body.row)));
      continue;
    }
    clean = false;
    reading_.findings.error(
        entry_place(entry),
        fmt::format("face {} already bounds body {} on this side", face_id(t), body_id(other)),
        fmt::format("body {} may lie on its other side: write {}", body_id(body.row), -signed_face(entry)),
        {{entry_place(claim), fmt::format("body {} lists it here", body_id(other))}});
  }
  return clean;
}

bool BodyCheck::all_sound(const Body& body) const {
  for (std::uint32_t entry = body.begin; entry < body.end; ++entry) {
    if (!face(entry).valid() || resolved_.sound_faces[face(entry).index] == 0) return false;
  }
  return !rows_.is_broken(ElementKind::body, body.row);
}

void BodyCheck::collect_meetings(const Body& body) {
  touched_.clear();
  for (std::uint32_t entry = body.begin; entry < body.end; ++entry) {
    if (repeated_[entry] != 0) continue;
    for (const SignedEdge e : loop(face(entry))) {
      Meeting& meeting = meetings_[e.edge().index];
      if (meeting.body != body.row) {
        meeting = {};
        meeting.body = body.row;
        touched_.push_back(e.edge());
      }
      meeting.sum += e.reversed() == (signed_face(entry) < 0) ? 1 : -1;
      if (meeting.uses == 0) meeting.first = entry;
      if (meeting.uses == 1) meeting.second = entry;
      ++meeting.uses;
    }
  }
}

// The faces of the body that meet at an edge which has just two of them, by entry.
std::vector<std::vector<BodyCheck::Neighbour>> BodyCheck::neighbours(const Body& body) const {
  std::vector<std::vector<Neighbour>> result(body.end - body.begin);
  for (const film::Edge e : touched_) {
    const Meeting& meeting = meetings_[e.index];
    if (meeting.uses != 2 || meeting.first == meeting.second) continue;
    result[meeting.first - body.begin].push_back({meeting.second, meeting.sum == 0});
    result[meeting.second - body.begin].push_back({meeting.first, meeting.sum == 0});
  }
  return result;
}

// The fewest faces that would have to be turned for neighbours to agree: each connected part of the boundary
// is split into those that agree and the others. Nothing where no turning helps, on a one-sided surface.
std::vector<std::uint32_t> BodyCheck::turned_faces(const Body& body) const {
  constexpr std::uint8_t unseen = 0;
  constexpr std::uint8_t upright = 1;
  constexpr std::uint8_t turned = 2;
  const std::vector<std::vector<Neighbour>> next_to = neighbours(body);
  std::vector<std::uint8_t> states(next_to.size(), unseen);
  const auto state = [&](std::uint32_t entry) -> std::uint8_t& { return states[entry - body.begin]; };
  std::vector<std::uint32_t> result;
  for (std::uint32_t start = body.begin; start < body.end; ++start) {
    if (state(start) != unseen) continue;
    state(start) = upright;
    std::vector<std::uint32_t> part{start};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::uint8_t own = state(part[i]);
      for (const Neighbour& next : next_to[part[i] - body.begin]) {
        const std::uint8_t wanted = next.agrees ? own : (own == upright ? turned : upright);
        if (state(next.entry) == unseen) part.push_back(next.entry);
        if (state(next.entry) != unseen && state(next.entry) != wanted) return {};
        state(next.entry) = wanted;
      }
    }
    const auto is_turned = [&](std::uint32_t entry) { return state(entry) == turned; };
    const auto count = static_cast<std::size_t>(std::count_if(part.begin(), part.end(), is_turned));
    const bool minority = 2 * count <= part.size();
    std::copy_if(part.begin(), part.end(), std::back_inserter(result),
                 [&](std::uint32_t entry) { return is_turned(entry) == minority; });
  }
  std::sort(result.begin(), result.end());
  return result;
}

void BodyCheck::report_turned(const Body& body, const std::vector<std::uint32_t>& turned) {
  constexpr std::size_t most_named = 10;
  std::string names;
  for (std::size_t i = 0; i < std::min(turned.size(), most_named); ++i) {
    names += fmt::format("{}{}", i == 0 ? "" : ", ", face_id(face(turned[i])));
  }
  if (turned.size() > most_named) names += fmt::format(" and {} more", turned.size() - most_named);
  const bool one = turned.size() == 1;
  reading_.findings.error(
      entry_place(turned.front()),
      fmt::format("face{} {} of body {} {} the other way than {} neighbours", one ? "" : "s", names,
                  body_id(body.row), one ? "faces" : "face", one ? "its" : "their"),
      fmt::format("the faces of a body are listed with their normals outward: write {}",
                  -signed_face(turned.front())));
}

void BodyCheck::report_gap(const Body& body, film::Edge edge) {
  const Numbering& bodies = rows_.of(ElementKind::body);
  reading_.findings.warning(
      reading_.tokens.place(bodies.spots[body.row]),
      fmt::format("body {} is not closed: at edge {} one of its faces ends where others go on",
                  body_id(body.row), rows_.of(ElementKind::edge).ids[edge.index]));
}

// By the volume under the faces, cut from their centres; seen from a point of the body, so that it does not
// matter where the body stands.
bool BodyCheck::is_inside_out(const Body& body) const {
  const auto position = [&](film::Vertex v) { return rows_.positions[v.index]; };
  const Vec3 origin = position(resolved_.tail(loop(face(body.begin)).front()));
  double volume = 0;
  double size = 0;
  for (std::uint32_t entry = body.begin; entry < body.end; ++entry) {
    if (repeated_[entry] != 0) continue;
    const std::span<const SignedEdge> edges = loop(face(entry));
    Vec3 centre;
    for (const SignedEdge e : edges) centre += position(resolved_.tail(e)) - origin;
    centre *= 1.0 / static_cast<double>(edges.size());
    for (const SignedEdge e : edges) {
      const Vec3 part = cross(position(resolved_.tail(e)) - origin, position(resolved_.head(e)) - origin);
      const double sixfold = dot(part, centre);
      volume += signed_face(entry) > 0 ? sixfold : -sixfold;
      size += std::abs(sixfold);
    }
  }
  constexpr double noticeable = 1e-9;
  return volume < -noticeable * size;
}

void BodyCheck::check_boundary(const Body& body) {
  collect_meetings(body);
  bool on_rims = false;
  bool balanced = true;
  film::Edge gap;
  for (const film::Edge e : touched_) {
    const Meeting& meeting = meetings_[e.index];
    if (meeting.sum == 0) continue;
    if (resolved_.faces_at_edge[e.index] == 1) {
      on_rims = true;
      continue;
    }
    balanced = false;
    if (!gap.valid() && meeting.uses % 2 == 1) gap = e;
  }
  if (!balanced) {
    const std::vector<std::uint32_t> turned = turned_faces(body);
    if (!turned.empty()) {
      report_turned(body, turned);
    } else if (gap.valid()) {
      report_gap(body, gap);
    }
  } else if (!on_rims && !reading_.periods && rows_.bodies[body.row].volume && is_inside_out(body)) {
    const Numbering& bodies = rows_.of(ElementKind::body);
    reading_.findings.error(reading_.tokens.place(bodies.spots[body.row]),
                            fmt::format("body {} is listed inside out", body_id(body.row)),
                            "its faces are listed with their normals outward: turn all signs");
  }
}

std::vector<film::RegionPair> BodyCheck::run() {
  const SignedLists& lists = rows_.body_faces;
  owner_.resize(lists.ids.size());
  repeated_.assign(lists.ids.size(), 0);
  for (std::uint32_t row = 0; row < rows_.bodies.size(); ++row) {
    std::fill(owner_.begin() + lists.begins[row], owner_.begin() + lists.begins[row + 1], row);
  }
  for (std::uint32_t row = 0; row < rows_.bodies.size(); ++row) {
    const Body body{row, lists.begins[row], lists.begins[row + 1]};
    const bool clean = claim_sides(body);
    if (clean && body.begin < body.end && all_sound(body)) check_boundary(body);
  }
  std::vector<film::RegionPair> result(claims_.size());
  for (std::size_t i = 0; i < claims_.size(); ++i) {
    if (claims_[i].front != nobody) result[i].front = regions_[owner_[claims_[i].front]];
    if (claims_[i].behind != nobody) result[i].behind = regions_[owner_[claims_[i].behind]];
  }
  return result;
}

}  // namespace

std::vector<film::RegionPair> check_bodies(Reading& reading, const Resolved& resolved,
                                           const std::vector<film::Region>& regions) {
  return BodyCheck(reading, resolved, regions).run();
}

}  // namespace lamella::datafile
