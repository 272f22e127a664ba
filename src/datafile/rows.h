// The elements of a datafile as they were read: rows of numbers with their places, nothing resolved yet.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "datafile/spot.h"
#include "film/column.h"
#include "film/ids.h"
#include "film/lattice.h"
#include "film/vec3.h"
#include "scene/scene.h"

namespace lamella::datafile {

// The largest number an element may have.
inline constexpr std::int64_t largest_id = 2147483647;

// The numbers of one kind of element, a row each, in the order of the file.
struct Numbering {
  std::vector<std::uint32_t> ids;
  std::vector<Spot> spots;
  // A row was too broken to tell its number, or the whole section is missing: what refers to an unknown
  // number is no mistake of its own then.
  bool incomplete = false;

  std::size_t size() const { return ids.size(); }
};

// A list of signed numbers for each row: the loop of a face, the faces of a body.
struct SignedLists {
  std::vector<std::uint32_t> begins{0};  // row i has the entries from begins[i] to begins[i + 1]
  std::vector<std::int32_t> ids;
  std::vector<Spot> spots;  // one an entry

  std::size_t begin(std::size_t row) const { return begins[row]; }
  std::size_t size(std::size_t row) const { return begins[row + 1] - begins[row]; }
  std::span<const std::int32_t> of(std::size_t row) const { return {ids.data() + begin(row), size(row)}; }
};

// A value with the place of the word that gave it.
struct GivenValue {
  double value = 0;
  Spot spot;
};

struct BodyRow {
  std::optional<GivenValue> volume;
  std::optional<GivenValue> pressure;
  std::optional<GivenValue> actual_volume;  // volconst is to make the volume this
  double volume_constant = 0;
  double density = 0;
  int phase = 0;
  double multiplier = 0;  // of the volume constraint, as a dump file has it
};

// An element that a named quantity is taken of.
struct Membership {
  std::uint32_t row = 0;
  std::string name;  // of the quantity or method, lower case
};

struct Rows {
  std::array<Numbering, 4> numbering;  // by film::ElementKind
  // Columns of the attributes that were given, long enough for the last row that has one.
  std::array<std::vector<film::Column>, 4> columns;
  // Numbers from an earlier datafile, with their rows.
  std::array<std::vector<std::pair<std::uint32_t, std::int32_t>>, 4> originals;
  // Rows with a mistake in them, of which no further ones are told.
  std::array<std::vector<std::uint8_t>, 4> broken;

  // What holds elements: rows with numbers of constraints (negative on edges that are integrated over
  // backwards) and of boundaries.
  std::array<std::vector<std::pair<std::uint32_t, int>>, 4> constraints;
  std::array<std::vector<std::pair<std::uint32_t, int>>, 4> boundaries;
  std::array<std::vector<Membership>, 4> memberships;
  std::vector<int> face_phases;             // as far as the string model's faces have some
  std::vector<std::uint32_t> turned_edges;  // rows marked `orientation -1`

  std::vector<film::Vec3> positions;  // of a vertex on a boundary: its parameters, until they are used
  std::vector<std::array<double, 3>> parameters;        // of the vertices on boundaries, in their order
  int coordinates = 0;                                  // that the last vertex was given
  std::vector<std::array<std::uint32_t, 2>> edge_ends;  // numbers of vertices
  std::vector<std::array<Spot, 2>> edge_end_spots;
  std::vector<film::Wrap> edge_wraps;  // in a periodic film
  SignedLists loops;                   // of the faces: signed edges
  SignedLists body_faces;              // signed faces
  std::vector<BodyRow> bodies;

  film::Wrap wrap_of(film::SignedEdge e) const {
    if (e.edge().index >= edge_wraps.size()) return {};
    const film::Wrap& w = edge_wraps[e.edge().index];
    return e.reversed() ? -w : w;
  }
  Numbering& of(film::ElementKind kind) { return numbering[static_cast<std::size_t>(kind)]; }
  const Numbering& of(film::ElementKind kind) const { return numbering[static_cast<std::size_t>(kind)]; }
  std::vector<film::Column>& columns_of(film::ElementKind kind) {
    return columns[static_cast<std::size_t>(kind)];
  }
  bool is_broken(film::ElementKind kind, std::size_t row) const {
    return broken[static_cast<std::size_t>(kind)][row] != 0;
  }
};

}  // namespace lamella::datafile
