// The film complex: a non-manifold surface of triangles in space, with wires, borders and regions.
//
// Every element is a row in flat arrays, addressed by a typed 32-bit id:
//
//   triangle   3 corners, 3 signed edges (edge k runs from corner k to corner k+1), the regions on its two
//   sides side       3t+k; the next side around the same edge edge       2 ends, one of its sides, the next
//   edge around each end vertex     position, one of its edges
//
// An edge without a side is a wire, with one a rim, with two lies inside a film, with three or more is a
// Plateau border: no case is special. A film open on all sides has the same region in front and behind.
// The sides around an edge are kept in geometric cyclic order, counterclockwise about the edge's own
// direction.
//
// An optional column (film/column.h) adds data to each element of a kind. Elements that are removed leave
// tombstones until `compact`; a film without tombstones is compact, and solvers ask for that (`view`).
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "film/column.h"
#include "film/ids.h"
#include "film/lattice.h"
#include "film/shared.h"
#include "film/vec3.h"

namespace lamella::film {

// One end of an edge: 2e for its tail, 2e+1 for its head.
struct EdgeEnd {
  std::uint32_t code = no_index;

  constexpr EdgeEnd() = default;
  constexpr explicit EdgeEnd(std::uint32_t c) : code(c) {}
  constexpr EdgeEnd(Edge e, int end) : code(2 * e.index + static_cast<std::uint32_t>(end)) {}

  constexpr bool valid() const { return code != no_index; }
  constexpr Edge edge() const { return Edge(code / 2); }
  constexpr int end() const { return static_cast<int>(code & 1U); }
  // The edge walked away from this end.
  constexpr SignedEdge outward() const { return SignedEdge(edge(), end() == 1); }
  friend constexpr auto operator<=>(const EdgeEnd&, const EdgeEnd&) = default;
};

// The arrays. A tombstone is a triangle or edge whose first vertex is invalid, and a vertex in `dead_vertex`
// state.
struct Connectivity {
  std::vector<std::array<Vertex, 3>> triangle_vertices;
  std::vector<std::array<SignedEdge, 3>> triangle_edges;
  std::vector<RegionPair> triangle_regions;
  std::vector<Side> next_side;                       // a ring through the sides of one edge; 3 a triangle
  std::vector<std::array<Vertex, 2>> edge_vertices;  // tail, head
  std::vector<Side> edge_side;                       // one of the edge's sides; invalid for a wire
  std::vector<std::array<EdgeEnd, 2>> next_end;      // a ring through the edge ends at one vertex
  std::vector<EdgeEnd> vertex_end;  // one of the edge ends at the vertex; invalid if isolated
  std::uint32_t dead_vertices = 0;
  std::uint32_t dead_edges = 0;
  std::uint32_t dead_triangles = 0;
};

inline constexpr EdgeEnd dead_vertex{0xfffffffeU};

// What solvers see: a compact film's arrays, valid until the film is changed.
struct View {
  std::span<const Vec3> positions;                   // one a vertex
  std::span<const std::array<Vertex, 3>> triangles;  // corners, counterclockwise seen from the front
  std::span<const RegionPair> regions;               // one a triangle
  std::span<const std::array<Vertex, 2>> edges;      // tail, head
  std::uint64_t connectivity_revision = 0;
};

class Film {
 public:
  // --- counts: rows include tombstones
  std::uint32_t vertex_rows() const { return static_cast<std::uint32_t>(connectivity_->vertex_end.size()); }
  std::uint32_t edge_rows() const { return static_cast<std::uint32_t>(connectivity_->edge_vertices.size()); }
  std::uint32_t triangle_rows() const {
    return static_cast<std::uint32_t>(connectivity_->triangle_vertices.size());
  }
  std::uint32_t vertex_count() const { return vertex_rows() - connectivity_->dead_vertices; }
  std::uint32_t edge_count() const { return edge_rows() - connectivity_->dead_edges; }
  std::uint32_t triangle_count() const { return triangle_rows() - connectivity_->dead_triangles; }
  bool alive(Vertex v) const {
    return v.index < vertex_rows() && connectivity_->vertex_end[v.index] != dead_vertex;
  }
  bool alive(Edge e) const {
    return e.index < edge_rows() && connectivity_->edge_vertices[e.index][0].valid();
  }
  bool alive(Triangle t) const {
    return t.index < triangle_rows() && connectivity_->triangle_vertices[t.index][0].valid();
  }
  bool is_compact() const;

  // --- reading the complex
  const Connectivity& connectivity() const { return *connectivity_; }
  const std::array<Vertex, 3>& corners(Triangle t) const { return connectivity_->triangle_vertices[t.index]; }
  const std::array<SignedEdge, 3>& edges(Triangle t) const { return connectivity_->triangle_edges[t.index]; }
  RegionPair regions(Triangle t) const { return connectivity_->triangle_regions[t.index]; }
  const std::array<Vertex, 2>& ends(Edge e) const { return connectivity_->edge_vertices[e.index]; }
  SignedEdge edge_of(Side s) const { return edges(s.triangle())[static_cast<std::size_t>(s.corner())]; }
  Vertex tail(SignedEdge e) const { return ends(e.edge())[e.reversed() ? 1 : 0]; }
  Vertex head(SignedEdge e) const { return ends(e.edge())[e.reversed() ? 0 : 1]; }
  Vertex opposite(Side s) const {
    return corners(s.triangle())[static_cast<std::size_t>(previous_corner(s.corner()))];
  }
  Vertex at(EdgeEnd end) const { return ends(end.edge())[static_cast<std::size_t>(end.end())]; }
  Side first_side(Edge e) const { return connectivity_->edge_side[e.index]; }
  Side next_around(Side s) const { return connectivity_->next_side[s.index]; }
  EdgeEnd first_end(Vertex v) const { return connectivity_->vertex_end[v.index]; }
  EdgeEnd next_around(EdgeEnd end) const {
    return connectivity_->next_end[end.edge().index][static_cast<std::size_t>(end.end())];
  }
  // The region met next when turning counterclockwise about the edge from this side, and the one before it.
  Region region_after(Side s) const;
  Region region_before(Side s) const;

  // Calls function(Side) for each side around an edge, in cyclic order.
  template <class Function>
  void for_each_side(Edge e, Function&& function) const {
    const Side first = first_side(e);
    if (!first.valid()) return;
    Side s = first;
    do {
      const Side next = next_around(s);  // read before the call: the function may unlink s
      function(s);
      s = next;
    } while (s != first);
  }
  // Calls function(EdgeEnd) for each edge end at a vertex, in no particular order.
  template <class Function>
  void for_each_end(Vertex v, Function&& function) const {
    const EdgeEnd first = first_end(v);
    if (!first.valid() || first == dead_vertex) return;
    EdgeEnd end = first;
    do {
      const EdgeEnd next = next_around(end);
      function(end);
      end = next;
    } while (end != first);
  }
  int valence(Edge e) const;    // number of sides
  int valence(Vertex v) const;  // number of edge ends
  // The edge between two vertices (the first found, where a film has several), or an invalid one.
  SignedEdge find_edge(Vertex from, Vertex to) const;

  // --- positions
  std::span<const Vec3> positions() const { return *positions_; }
  const Vec3& position(Vertex v) const { return (*positions_)[v.index]; }
  // Along an edge from its tail to its head; the corners of a facet, unfolded from the first one. What looks
  // at the shape of the film asks for these: in a periodic film two vertices of one edge need not lie near
  // each other.
  Vec3 vector(SignedEdge e) const {
    const Vec3 plain = position(head(e)) - position(tail(e));
    return lattice_ ? plain + lattice_->shift(wrap(e)) : plain;
  }
  Vec3 vector(Edge e) const { return vector(SignedEdge(e, false)); }
  std::array<Vec3, 3> points(Triangle t) const {
    const std::array<Vertex, 3>& v = corners(t);
    if (lattice_) return unfolded_points(t);
    return {position(v[0]), position(v[1]), position(v[2])};
  }
  std::span<Vec3> edit_positions() { return positions_.edit(); }
  void move(Vertex v, const Vec3& to) { positions_.edit()[v.index] = to; }
  std::uint64_t position_revision() const { return positions_.revision(); }
  std::uint64_t connectivity_revision() const { return connectivity_.revision(); }

  // --- building and removing
  Vertex add_vertex(const Vec3& position);
  Edge add_edge(Vertex tail, Vertex head);
  // The three edges must run head to tail. The sides join the ends of their edges' rings; `sort_sides`
  // puts a ring of three or more into geometric order.
  Triangle add_triangle(const std::array<SignedEdge, 3>& edges, RegionPair regions);
  void remove(Triangle t);
  void remove(Edge e);    // must be a wire
  void remove(Vertex v);  // must be isolated
  // For surgery that keeps ring order by itself: a triangle in no ring yet; new edges for a triangle, rings
  // untouched; a ring given whole (each side once); a side put in another's place in its ring.
  Triangle add_unlinked_triangle(const std::array<SignedEdge, 3>& edges, RegionPair regions);
  void rewrite(Triangle t, const std::array<SignedEdge, 3>& edges);
  void set_ring(Edge e, std::span<const Side> sides);
  void replace_in_ring(Edge e, Side old, Side made);
  // Lets an edge end at another vertex; triangles are not told.
  void reattach(EdgeEnd end, Vertex to);
  // Puts the rings of sides and of ends into an order that follows from the rows alone, as in a film that was
  // just read: what is done to it next is then the same, to the last bit. Around an edge the ring stays and
  // begins with its lowest side; around a vertex ends stand as if edges had been added row by row.
  void begin_rings_alike();
  void set_regions(Triangle t, RegionPair regions) {
    connectivity_.edit().triangle_regions[t.index] = regions;
  }
  void sort_sides(Edge e);
  void sort_all_sides();
  void reserve(std::size_t vertices, std::size_t edges, std::size_t triangles);
  // Direct access for operations that rebuild whole arrays; the caller answers for every invariant, and
  // calls `columns_follow_rows` when rows were added.
  Connectivity& edit_connectivity() { return connectivity_.edit(); }
  std::vector<Vec3>& edit_position_rows() { return positions_.edit(); }
  void columns_follow_rows();
  // Takes over another film's complex and positions; columns stay and grow or shrink to its rows, numbers
  // start again.
  void take_complex(Film&& other);

  // --- periods (film/lattice.h)
  bool periodic() const { return lattice_ != nullptr; }
  const Lattice* lattice() const { return lattice_.get(); }  // null where the film is not periodic
  // Edges without wraps get none.
  void set_lattice(const Lattice& lattice);
  Wrap wrap(SignedEdge e) const;  // of a film that is periodic
  void set_wrap(Edge e, const Wrap& wrap);
  // Wraps an edge so that its vector comes nearest to this one. Does nothing where there are no periods.
  void aim(SignedEdge e, const Vec3& vector);
  // The wraps of a facet's corners, as seen from the first one.
  std::array<Wrap, 3> corner_wraps(Triangle t) const;
  // Moves a vertex by whole periods; its edges' wraps follow, so that nothing changes its shape.
  void move_by_periods(Vertex v, const Wrap& wrap);
  // Moves every vertex into the cell that the periods span from the origin.
  void gather_in_cell();

  // --- columns
  const Columns& columns(ElementKind kind) const { return columns_[static_cast<std::size_t>(kind)]; }
  Columns& columns(ElementKind kind) { return columns_[static_cast<std::size_t>(kind)]; }
  // Inheritance (film/column.h), for whoever makes elements:
  void inherit(Vertex made, Edge split);  // made on an edge, between its present ends
  void inherit(Vertex made, Vertex a, Vertex b,
               Edge split);                    // the same, where the edge no longer ends at a and b
  void inherit(Vertex made, Triangle inside);  // made inside a facet
  void inherit(Edge half, Edge split);
  void inherit(Edge made, Triangle inside);
  void inherit(Triangle part, Triangle whole);

  // --- numbers that people see (counted from 1; they survive compaction)
  std::uint32_t number(Vertex v) const { return (*numbers_[0])[v.index]; }
  std::uint32_t number(Edge e) const { return (*numbers_[1])[e.index]; }
  std::uint32_t number(Triangle t) const { return (*numbers_[2])[t.index]; }
  Vertex vertex_numbered(std::uint32_t number) const;  // invalid if there is none
  Edge edge_numbered(std::uint32_t number) const;
  Triangle triangle_numbered(std::uint32_t number) const;

  // --- compaction
  // Drops tombstones; the others keep their order and numbers.
  void compact();
  // Rewrites all arrays: row i becomes what was row order[i]. Every live row must occur, and no dead one.
  void renumber(std::span<const std::uint32_t> vertices, std::span<const std::uint32_t> edges,
                std::span<const std::uint32_t> triangles);
  // Forgets the numbers: they count the present rows again.
  void restart_numbers();
  // One number for each row, all different.
  void set_numbers(ElementKind kind, std::vector<std::uint32_t> numbers);

  // Requires is_compact().
  View view() const;

  // Bytes in use by the arrays (without and with columns).
  std::size_t bytes() const;
  std::size_t bytes_with_columns() const;

 private:
  // The numbers of one kind of element. No rows mean: row + 1.
  struct Numbers {
    std::vector<std::uint32_t> of_row;
    std::uint32_t last = 0;  // the highest ever given, where there are rows

    std::uint32_t operator[](std::uint32_t row) const { return of_row.empty() ? row + 1 : of_row[row]; }
    std::uint32_t row(std::uint32_t number, std::uint32_t rows) const;
    void append() {
      if (!of_row.empty()) of_row.push_back(++last);
    }
    Numbers renumbered(std::span<const std::uint32_t> old_of_new) const;
  };
  void insert_end(EdgeEnd end, Vertex v);
  void remove_end(EdgeEnd end, Vertex v);
  void insert_side(Side s, Edge e);
  void remove_side(Side s, Edge e);
  std::array<Vec3, 3> unfolded_points(Triangle t) const;

  Shared<Connectivity> connectivity_;
  Shared<std::vector<Vec3>> positions_;
  std::array<Shared<Numbers>, 3> numbers_;  // vertex, edge, facet
  std::array<Columns, 3> columns_;          // vertex, edge, facet
  std::shared_ptr<const Lattice> lattice_;
};

// The column of edges that holds the wraps of a periodic film: three integers a row.
inline constexpr const char* wrap_column = "wraps";

// The vector from the tail of an edge to the opposite corner of a side, for ordering sides around it.
Vec3 apex_direction(const Film& film, Side s);

}  // namespace lamella::film
