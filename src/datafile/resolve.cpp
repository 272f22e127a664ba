#include "datafile/resolve.h"

#include <cstdlib>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/id_table.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;
using film::SignedEdge;
using film::Vertex;

class Resolver {
 public:
  explicit Resolver(Reading& reading)
      : reading_(reading),
        rows_(reading.rows),
        vertices_(table(ElementKind::vertex)),
        edges_(table(ElementKind::edge)),
        faces_(table(ElementKind::facet)) {
    static_cast<void>(table(ElementKind::body));  // for its duplicates
  }

  Resolved resolve();

 private:
  IdTable table(ElementKind kind);
  std::uint32_t find(const IdTable& table, ElementKind kind, std::int64_t id, Spot spot);
  void edges();
  void loops();
  void loop(std::size_t face);
  bool closes(std::size_t face);
  bool wraps_cancel(std::size_t face);
  void report_gap(std::size_t face, std::size_t entry, bool at_the_end);
  void body_faces();
  std::uint32_t vertex_id(Vertex v) const { return rows_.of(ElementKind::vertex).ids[v.index]; }
  std::uint32_t edge_id(SignedEdge e) const { return rows_.of(ElementKind::edge).ids[e.edge().index]; }

  Reading& reading_;
  const Rows& rows_;
  IdTable vertices_;
  IdTable edges_;
  IdTable faces_;
  Resolved result_;
};

IdTable Resolver::table(ElementKind kind) {
  const Numbering& numbering = rows_.of(kind);
  IdTable result(numbering.ids);
  for (const auto& [again, first] : result.duplicates()) {
    const text::Place defined = reading_.tokens.place(numbering.spots[first]);
    reading_.findings.error(reading_.tokens.place(numbering.spots[again]),
                            fmt::format("{} {} is defined already, on line {}", element_name(kind),
                                        numbering.ids[again], text::line_and_column(defined).line),
                            {}, {{defined, "first defined here"}});
  }
  return result;
}

// The row of a number; reports where there is none, unless a mistake elsewhere may have kept it from being
// read.
std::uint32_t Resolver::find(const IdTable& table, ElementKind kind, std::int64_t id, Spot spot) {
  const std::uint32_t row = table.row(static_cast<std::uint32_t>(std::abs(id)));
  if (row == IdTable::none && !rows_.of(kind).incomplete) {
    reading_.findings.error(reading_.tokens.place(spot),
                            fmt::format("{} {} is not defined", element_name(kind), std::abs(id)));
  }
  return row;
}

void Resolver::edges() {
  const std::size_t count = rows_.edge_ends.size();
  result_.edge_ends.resize(count);
  for (std::size_t e = 0; e < count; ++e) {
    if (rows_.is_broken(ElementKind::edge, e) && rows_.edge_ends[e][0] == 0) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      const std::uint32_t id = rows_.edge_ends[e][end];
      result_.edge_ends[e][end] =
          Vertex(find(vertices_, ElementKind::vertex, id, rows_.edge_end_spots[e][end]));
    }
    const auto& [tail, head] = result_.edge_ends[e];
    const bool around = e < rows_.edge_wraps.size() && rows_.edge_wraps[e] != film::Wrap{};
    if (tail.valid() && tail == head && !around) {
      reading_.findings.error(reading_.tokens.place(rows_.edge_end_spots[e][1]),
                              fmt::format("edge {} begins and ends at vertex {}",
                                          rows_.of(ElementKind::edge).ids[e], vertex_id(tail)));
      result_.edge_ends[e] = {};
    }
  }
}

void Resolver::loops() {
  const SignedLists& lists = rows_.loops;
  result_.loops.resize(lists.ids.size());
  result_.sound_faces.assign(rows_.of(ElementKind::facet).size(), 0);
  result_.faces_at_edge.assign(result_.edge_ends.size(), 0);
  for (std::size_t face = 0; face < result_.sound_faces.size(); ++face) {
    loop(face);
    if (reading_.scene.strings.on) continue;  // cells need not close
    result_.sound_faces[face] = !rows_.is_broken(ElementKind::facet, face) && closes(face) ? 1 : 0;
  }
}

void Resolver::loop(std::size_t face) {
  const SignedLists& lists = rows_.loops;
  for (std::size_t i = lists.begins[face]; i < lists.begins[face + 1]; ++i) {
    const std::int32_t id = lists.ids[i];
    const std::uint32_t row = find(edges_, ElementKind::edge, id, lists.spots[i]);
    if (row == IdTable::none) continue;
    result_.loops[i] = SignedEdge(film::Edge(row), id < 0);
    ++result_.faces_at_edge[row];
  }
}

bool Resolver::closes(std::size_t face) {
  const std::size_t begin = rows_.loops.begins[face];
  const std::size_t end = rows_.loops.begins[face + 1];
  for (std::size_t i = begin; i < end; ++i) {
    const SignedEdge e = result_.loops[i];
    if (!e.valid() || !result_.tail(e).valid() || !result_.head(e).valid()) return false;  // told already
  }
  if (end - begin < 3) {
    const Numbering& faces = rows_.of(ElementKind::facet);
    reading_.findings.error(
        reading_.tokens.place(faces.spots[face]),
        fmt::format("face {} has only {}", faces.ids[face], end - begin == 1 ? "one edge" : "two edges"),
        "a face is a loop of three edges or more");
    return false;
  }
  for (std::size_t i = begin; i + 1 < end; ++i) {
    if (result_.head(result_.loops[i]) == result_.tail(result_.loops[i + 1])) continue;
    report_gap(face, i + 1, false);
    return false;
  }
  if (result_.head(result_.loops[end - 1]) != result_.tail(result_.loops[begin])) {
    report_gap(face, end - 1, true);
    return false;
  }
  return !reading_.periods || wraps_cancel(face);
}

bool Resolver::wraps_cancel(std::size_t face) {
  film::Wrap sum;
  for (std::size_t i = rows_.loops.begins[face]; i < rows_.loops.begins[face + 1]; ++i)
    sum = sum + rows_.wrap_of(result_.loops[i]);
  if (sum == film::Wrap{}) return true;
  const Numbering& faces = rows_.of(ElementKind::facet);
  reading_.findings.error(
      reading_.tokens.place(faces.spots[face]),
      fmt::format("face {} does not close: around it one comes to an image of its first vertex, {} {} {} "
                  "periods away",
                  faces.ids[face], sum[0], sum[1], sum[2]),
      "the signs of its edges have to cancel");
  return false;
}

// The loop breaks before an entry, or after the last one.
void Resolver::report_gap(std::size_t face, std::size_t entry, bool at_the_end) {
  const SignedLists& lists = rows_.loops;
  const SignedEdge e = result_.loops[entry];
  const std::uint32_t face_id = rows_.of(ElementKind::facet).ids[face];
  const text::Place place = reading_.tokens.place(lists.spots[entry]);
  if (at_the_end) {
    const SignedEdge first = result_.loops[lists.begins[face]];
    reading_.findings.error(
        place, fmt::format("face {} does not close: edge {} ends at vertex {}, and the first edge "
                           "begins at vertex {}",
                           face_id, edge_id(e), vertex_id(result_.head(e)), vertex_id(result_.tail(first))));
    return;
  }
  const Vertex wanted = result_.head(result_.loops[entry - 1]);
  const std::string hint = result_.head(e) == wanted
                               ? fmt::format("walked the other way it fits: write {}", -lists.ids[entry])
                               : std::string{};
  reading_.findings.error(
      place,
      fmt::format("face {} does not close: edge {} begins at vertex {}, and the edge before "
                  "it ends at vertex {}",
                  face_id, edge_id(e), vertex_id(result_.tail(e)), vertex_id(wanted)),
      hint);
}

void Resolver::body_faces() {
  const SignedLists& lists = rows_.body_faces;
  result_.body_faces.reserve(lists.ids.size());
  for (std::size_t i = 0; i < lists.ids.size(); ++i) {
    result_.body_faces.emplace_back(find(faces_, ElementKind::facet, lists.ids[i], lists.spots[i]));
  }
}

Resolved Resolver::resolve() {
  edges();
  loops();
  body_faces();
  return std::move(result_);
}

}  // namespace

Resolved resolve(Reading& reading) {
  return Resolver(reading).resolve();
}

}  // namespace lamella::datafile
