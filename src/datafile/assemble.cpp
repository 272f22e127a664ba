#include "datafile/assemble.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/element_constraints.h"
#include "datafile/quantities.h"
#include "film/check.h"
#include "film/ring.h"

namespace lamella::datafile {

namespace {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;

// The parts that a face of more than three edges is cut into.
struct Cut {
  std::uint32_t face = 0;
  Vertex centre;
  Edge first_spoke;     // from the tail of the first edge to the centre; the others follow
  Triangle first_part;  // at the first edge; the others follow, but for the last, which is the face itself
};

class Assembler {
 public:
  Assembler(Reading& reading, const Resolved& resolved, const std::vector<film::RegionPair>& face_regions)
      : reading_(reading),
        rows_(reading.rows),
        resolved_(resolved),
        regions_(face_regions),
        film_(reading.scene.film) {}

  void run();

 private:
  std::span<const SignedEdge> loop(std::size_t face) const {
    return {resolved_.loops.data() + rows_.loops.begin(face), rows_.loops.size(face)};
  }
  SignedEdge spoke(const Cut& cut, std::size_t corner) const {
    return {Edge(cut.first_spoke.index + corner), false};
  }
  void plan_cuts();
  void add_vertices();
  void add_edges();
  void add_triangles();
  void begin_rings();
  void wrap_edges();
  void add_columns(ElementKind kind);
  void add_cells();
  void add_inheriting_columns();
  void add_original(ElementKind kind);
  void inherit_in_cuts();
  void set_centre(const Cut& cut);
  void place_centres();
  void number_elements();
  void number_kind(ElementKind kind, std::size_t count);

  Reading& reading_;
  Rows& rows_;
  const Resolved& resolved_;
  const std::vector<film::RegionPair>& regions_;
  Film& film_;
  std::vector<Cut> cuts_;
  std::size_t spokes_ = 0;
  std::size_t parts_ = 0;
};

void Assembler::plan_cuts() {
  if (reading_.scene.strings.on) return;
  const std::size_t faces = rows_.of(ElementKind::facet).size();
  for (std::uint32_t face = 0; face < faces; ++face) {
    const std::size_t corners = loop(face).size();
    if (corners == 3) continue;
    cuts_.push_back({face, Vertex(rows_.positions.size() + cuts_.size()),
                     Edge(rows_.edge_ends.size() + spokes_), Triangle(faces + parts_)});
    spokes_ += corners;
    parts_ += corners - 1;
  }
  film_.reserve(rows_.positions.size() + cuts_.size(), rows_.edge_ends.size() + spokes_, faces + parts_);
}

void Assembler::add_vertices() {
  for (const Vec3& position : rows_.positions) film_.add_vertex(position);
  for (std::size_t i = 0; i < cuts_.size(); ++i) film_.add_vertex({});
}

// At the mean of the corners, as seen from the first one.
void Assembler::place_centres() {
  std::vector<Vec3> corners;
  for (const Cut& cut : cuts_) {
    const std::span<const SignedEdge> edges = loop(cut.face);
    corners.clear();
    Vec3 sum;
    for (const SignedEdge e : edges) {
      Vec3 at = film_.position(resolved_.tail(e));
      if (film_.periodic() && !corners.empty()) at = corners.back() + film_.vector(edges[corners.size() - 1]);
      corners.push_back(at);
      sum += at;
    }
    const Vec3 centre = sum / static_cast<double>(edges.size());
    film_.move(cut.centre, centre);
    for (std::size_t i = 0; i < edges.size(); ++i) film_.aim(spoke(cut, i), centre - corners[i]);
  }
}

void Assembler::wrap_edges() {
  film_.set_lattice(film::Lattice(*reading_.periods));
  for (std::uint32_t e = 0; e < rows_.edge_wraps.size(); ++e) film_.set_wrap(Edge(e), rows_.edge_wraps[e]);
}

void Assembler::add_edges() {
  for (const auto& [tail, head] : resolved_.edge_ends) film_.add_edge(tail, head);
  for (const Cut& cut : cuts_) {
    for (const SignedEdge e : loop(cut.face)) film_.add_edge(resolved_.tail(e), cut.centre);
  }
}

void Assembler::add_triangles() {
  if (reading_.scene.strings.on) return;
  std::size_t next_cut = 0;
  for (std::size_t face = 0; face < rows_.of(ElementKind::facet).size(); ++face) {
    const std::span<const SignedEdge> edges = loop(face);
    if (edges.size() == 3) {
      film_.add_triangle({edges[0], edges[1], edges[2]}, regions_[face]);
    } else {
      const Cut& cut = cuts_[next_cut++];
      film_.add_triangle({-spoke(cut, edges.size() - 1), edges.back(), spoke(cut, 0)}, regions_[face]);
    }
  }
  for (const Cut& cut : cuts_) {
    const std::span<const SignedEdge> edges = loop(cut.face);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      film_.add_triangle({edges[i], spoke(cut, i + 1), -spoke(cut, i)}, regions_[cut.face]);
    }
  }
}

// The side that comes first around an edge between two faces is of the face that stands first in the file, as
// the elder program has it: the directions of flipped edges, and so scripts that name them, depend on it.
void Assembler::begin_rings() {
  if (cuts_.empty()) return;
  std::vector<std::uint8_t> seen(film_.edge_rows(), 0);
  const auto begin_at = [&](Side side) {
    if (!std::exchange(seen[film_.edge_of(side).edge().index], 1)) film::begin_ring(film_, side);
  };
  std::size_t next_cut = 0;
  for (std::uint32_t face = 0; face < rows_.of(ElementKind::facet).size(); ++face) {
    const auto corners = static_cast<std::uint32_t>(loop(face).size());
    if (corners == 3) {
      for (int i = 0; i < 3; ++i) begin_at(Side(Triangle(face), i));
      continue;
    }
    const Triangle part = cuts_[next_cut++].first_part;
    for (std::uint32_t i = 0; i + 1 < corners; ++i) begin_at(Side(Triangle(part.index + i), 0));
    begin_at(Side(Triangle(face), 1));
    begin_at(Side(Triangle(part.index + corners - 2), 1));  // the last spoke, where it is walked
  }
}

// --- columns

// A back that looks like its front everywhere needs no column of its own.
void drop_needless_backcolor(std::vector<film::Column>& columns) {
  const auto find = [&](std::string_view name) {
    return std::find_if(columns.begin(), columns.end(),
                        [&](const auto& column) { return column.name == name; });
  };
  const auto front = find("color");
  const auto back = find("backcolor");
  if (front != columns.end() && back != columns.end() && front->data == back->data) columns.erase(back);
}

void Assembler::add_columns(ElementKind kind) {
  film::Columns& to = kind == ElementKind::body ? reading_.scene.body_columns : film_.columns(kind);
  for (film::Column& column : rows_.columns_of(kind)) {
    if (kind != ElementKind::body || column.name != ramp_name) to.add(std::move(column));
  }
  if (kind != ElementKind::body) add_original(kind);
}

// Faces of the string model; edges have a tension of 1 unless they say otherwise.
void Assembler::add_cells() {
  const std::vector<std::uint32_t>& ids = rows_.of(ElementKind::facet).ids;
  std::vector<std::vector<int>> cells_of(film_.edge_rows());
  for (std::size_t face = 0; face < ids.size(); ++face) {
    const int number = static_cast<int>(face) + 1;
    reading_.scene.strings.cells.push_back({regions_[face], ids[face]});
    for (const SignedEdge e : loop(face)) cells_of[e.edge().index].push_back(e.reversed() ? -number : number);
  }
  film::Column column = film::integer_column(scene::cells_column);
  for (const std::vector<int>& cells : cells_of)
    column.width = std::max(column.width, static_cast<int>(cells.size()));
  column.shape = {column.width};
  film::Columns& columns = film_.columns(ElementKind::edge);
  film::Column& added = columns.add(std::move(column));
  for (std::uint32_t row = 0; row < cells_of.size(); ++row) {
    for (std::size_t k = 0; k < cells_of[row].size(); ++k)
      added.set(row, static_cast<int>(k), cells_of[row][k]);
  }
  if (columns.find("tension") == nullptr) columns.add(film::real_column("tension", 1));
}

// What splits a fixed edge is fixed, what is drawn inside a fixed face too: so where faces or edges have such
// a column, edges and vertices need one.
void Assembler::add_inheriting_columns() {
  const auto has = [&](ElementKind kind, std::string_view name) {
    return film_.columns(kind).find(name) != nullptr;
  };
  for (const ElementKind kind : {ElementKind::edge, ElementKind::vertex}) {
    for (const KnownColumn& known : known_columns()) {
      if (known.kind != kind || known.on_new != film::Inheritance::New::parent || has(kind, known.name))
        continue;
      const bool from_edges = kind == ElementKind::vertex && has(ElementKind::edge, known.name);
      if (from_edges || has(ElementKind::facet, known.name)) film_.columns(kind).add(make_column(known));
    }
  }
}

// The number in the datafile, or in the one it comes from; 0 for what a cut has made.
void Assembler::add_original(ElementKind kind) {
  film::Column& column = film_.columns(kind).add(make_column(*known_column(kind, "original")));
  auto& values = std::get<film::Integers>(column.data);
  const std::vector<std::uint32_t>& ids = rows_.of(kind).ids;
  for (std::size_t row = 0; row < ids.size(); ++row) values[row] = static_cast<std::int32_t>(ids[row]);
  for (const auto& [row, original] : rows_.originals[static_cast<std::size_t>(kind)]) values[row] = original;
}

void Assembler::inherit_in_cuts() {
  for (const Cut& cut : cuts_) {
    const Triangle whole(cut.face);
    const std::size_t corners = loop(cut.face).size();
    for (std::size_t i = 0; i + 1 < corners; ++i) film_.inherit(Triangle(cut.first_part.index + i), whole);
    for (std::size_t i = 0; i < corners; ++i) film_.inherit(spoke(cut, i).edge(), whole);
    set_centre(cut);
  }
}

// Where a new vertex gets the mean of its neighbours, a centre gets the mean of the corners.
void Assembler::set_centre(const Cut& cut) {
  const film::Columns& facets = film_.columns(ElementKind::facet);
  film_.columns(ElementKind::vertex).edit_each([&](film::Column& column) {
    if (column.inheritance.on_new == film::Inheritance::New::parent) {
      if (const film::Column* source = facets.find(column.name))
        column.copy_row_of(*source, cut.face, cut.centre.index);
    } else if (column.inheritance.on_new == film::Inheritance::New::mean) {
      const std::span<const SignedEdge> edges = loop(cut.face);
      for (int k = 0; k < column.width; ++k) {
        double sum = 0;
        for (const SignedEdge e : edges) sum += column.value(resolved_.tail(e).index, k);
        column.set(cut.centre.index, k, sum / static_cast<double>(edges.size()));
      }
    }
  });
}

// --- numbers

// The elements of the file keep theirs, what a cut has made gets the lowest free ones.
void Assembler::number_kind(ElementKind kind, std::size_t count) {
  std::vector<std::uint32_t> numbers = rows_.of(kind).ids;
  std::vector<std::uint32_t> taken = numbers;
  std::sort(taken.begin(), taken.end());
  std::uint32_t next = 1;
  auto at = taken.begin();
  while (numbers.size() < count) {
    for (; at != taken.end() && *at == next; ++at) ++next;
    numbers.push_back(next++);
  }
  film_.set_numbers(kind, std::move(numbers));
}

void Assembler::number_elements() {
  if (!reading_.keep_originals) return;
  number_kind(ElementKind::vertex, film_.vertex_rows());
  number_kind(ElementKind::edge, film_.edge_rows());
  if (!reading_.scene.strings.on) number_kind(ElementKind::facet, film_.triangle_rows());
}

void Assembler::run() {
  plan_cuts();
  add_vertices();
  add_edges();
  add_triangles();
  begin_rings();
  if (reading_.periods) wrap_edges();
  drop_needless_backcolor(rows_.columns_of(ElementKind::facet));
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge}) add_columns(kind);
  if (reading_.scene.strings.on) {
    add_cells();
  } else {
    add_columns(ElementKind::facet);
  }
  add_inheriting_columns();
  add_constraints(reading_);
  add_memberships(reading_);
  inherit_in_cuts();
  project_vertices_of_file(reading_);
  place_centres();
  project_centres(reading_);
  number_elements();
  film_.sort_all_sides();
  assert(film::check(film_).empty());
}

// --- bodies

// What lies under the facets of a region, measured as the scene does (scene::Scene::symmetric_content).
double volume_under(const scene::Scene& scene, film::Region region) {
  double volume = 0;
  const Film& film = scene.film;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const film::RegionPair pair = film.regions(Triangle(t));
    const int sign = (pair.behind == region ? 1 : 0) - (pair.front == region ? 1 : 0);
    if (sign == 0) continue;
    const auto& corner = film.corners(Triangle(t));
    const Vec3 a = film.position(corner[0]);
    const Vec3 b = film.position(corner[1]);
    const Vec3 c = film.position(corner[2]);
    const double part = scene.symmetric_content ? dot(a, cross(b, c)) / 6
                                                : 0.5 * cross(b - a, c - a).z * (a.z + b.z + c.z) / 3;
    volume += sign * part;
  }
  return volume;
}

std::optional<scene::VolumeRamp> ramp_of(const film::Column* column, std::uint32_t row) {
  if (column == nullptr) return std::nullopt;
  const scene::VolumeRamp ramp{column->value(row, 0), column->value(row, 1), column->value(row, 2),
                               column->value(row, 3)};
  return ramp.end > ramp.begin ? std::optional(ramp) : std::nullopt;
}

scene::Body body_of(const BodyRow& row, std::uint32_t id) {
  scene::Body body;
  body.original = id;
  if (row.volume) body.target_volume = row.volume->value;
  if (row.pressure) body.fixed_pressure = row.pressure->value;
  body.pressure = row.pressure ? row.pressure->value : row.multiplier;
  body.density = row.density;
  body.phase = row.phase;
  body.volume_offset = row.volume_constant;
  return body;
}

// One row of the scene's bodies for each region.
void assemble_bodies(Reading& reading, const std::vector<film::Region>& regions) {
  scene::Scene& scene = reading.scene;
  Rows& rows = reading.rows;
  std::uint32_t last = 0;
  for (const film::Region region : regions) last = std::max(last, region.index);
  scene.bodies.resize(last);
  for (scene::Body& body : scene.bodies) body.absent = true;
  std::vector<film::Column>& columns = rows.columns_of(ElementKind::body);
  for (film::Column& column : columns) column.resize(rows.bodies.size());
  const auto ramps =
      std::find_if(columns.begin(), columns.end(), [](const auto& c) { return c.name == ramp_name; });
  for (std::uint32_t row = 0; row < rows.bodies.size(); ++row) {
    scene::Body& body = scene.body(regions[row]);
    body = body_of(rows.bodies[row], rows.of(ElementKind::body).ids[row]);
    if (const auto& actual = rows.bodies[row].actual_volume) {
      body.volume_offset = actual->value - volume_under(scene, regions[row]);
    }
    // It makes up for how another program counts periods.
    if (scene.film.periodic()) body.volume_offset = 0;
    body.ramp = ramp_of(ramps == columns.end() ? nullptr : &*ramps, row);
  }
  for (const auto& [row, original] : rows.originals[static_cast<std::size_t>(ElementKind::body)]) {
    scene.body(regions[row]).original = static_cast<std::uint32_t>(std::max(0, original));
  }
  scene.body_columns.resize(last);
  for (const film::Column& column : columns) {
    if (column.name == ramp_name) continue;
    film::Column spread = column;
    spread.resize(0);
    film::Column& to = scene.body_columns.add(std::move(spread));
    for (std::uint32_t row = 0; row < rows.bodies.size(); ++row)
      to.copy_row_of(column, row, regions[row].index - 1);
  }
}

}  // namespace

std::vector<film::Region> number_bodies(Reading& reading) {
  const Numbering& bodies = reading.rows.of(ElementKind::body);
  std::vector<film::Region> regions;
  regions.reserve(bodies.size());
  for (std::uint32_t row = 0; row < bodies.size(); ++row) {
    regions.push_back({reading.keep_originals ? bodies.ids[row] : row + 1});
    if (regions.back().index <= 100 * bodies.size() + 1000) continue;
    reading.findings.error(
        reading.tokens.place(bodies.spots[row]),
        fmt::format("the number of body {} is too large for \"keep_originals\"", bodies.ids[row]),
        "number the bodies from 1");
    regions.back() = {row + 1};
  }
  return regions;
}

void assemble(Reading& reading, const Resolved& resolved, const std::vector<film::Region>& body_regions,
              const std::vector<film::RegionPair>& face_regions) {
  Assembler(reading, resolved, face_regions).run();
  assemble_bodies(reading, body_regions);
}

}  // namespace lamella::datafile
