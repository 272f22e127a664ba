#include "film/check.h"

#include <cmath>

#include <fmt/format.h>

namespace lamella::film {

namespace {

class Findings {
 public:
  explicit Findings(std::size_t most) : most_(most) {}
  bool full() const { return list_.size() >= most_; }
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    if (!full()) list_.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
  }
  std::vector<std::string> take() { return std::move(list_); }

 private:
  std::size_t most_;
  std::vector<std::string> list_;
};

void check_sizes(const Film& film, Findings& findings) {
  const Connectivity& c = film.connectivity();
  const std::size_t v = c.vertex_end.size();
  const std::size_t e = c.edge_vertices.size();
  const std::size_t t = c.triangle_vertices.size();
  if (film.positions().size() != v) findings.add("{} positions for {} vertices", film.positions().size(), v);
  if (c.edge_side.size() != e || c.next_end.size() != e) findings.add("edge arrays of different lengths");
  if (c.triangle_edges.size() != t || c.triangle_regions.size() != t || c.next_side.size() != 3 * t) {
    findings.add("triangle arrays of different lengths");
  }
  const std::array<std::size_t, 3> rows{v, e, t};
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    const std::size_t wanted = rows[static_cast<std::size_t>(kind)];
    film.columns(kind).for_each([&](const Column& column) {
      const std::size_t has = std::visit([](const auto& values) { return values.size(); }, column.data);
      if (has != wanted * static_cast<std::size_t>(column.width)) {
        findings.add("the {} column \"{}\" has {} values for {} rows of {}", name_of(kind), column.name, has,
                     wanted, column.width);
      }
    });
  }
}

void check_counts(const Film& film, Findings& findings) {
  const Connectivity& c = film.connectivity();
  std::uint32_t dead_vertices = 0;
  std::uint32_t dead_edges = 0;
  std::uint32_t dead_triangles = 0;
  for (std::uint32_t i = 0; i < film.vertex_rows(); ++i) dead_vertices += film.alive(Vertex(i)) ? 0 : 1;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) dead_edges += film.alive(Edge(i)) ? 0 : 1;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) dead_triangles += film.alive(Triangle(i)) ? 0 : 1;
  if (dead_vertices != c.dead_vertices || dead_edges != c.dead_edges || dead_triangles != c.dead_triangles) {
    findings.add("the counts of removed elements are wrong");
  }
}

void check_vertices(const Film& film, Findings& findings) {
  for (std::uint32_t i = 0; i < film.vertex_rows() && !findings.full(); ++i) {
    const Vertex v(i);
    if (!film.alive(v)) continue;
    if (!is_finite(film.position(v)))
      findings.add("vertex {} has a coordinate that is not finite", film.number(v));
    const EdgeEnd end = film.first_end(v);
    if (end.valid() && (!film.alive(end.edge()) || film.at(end) != v)) {
      findings.add("vertex {} refers to an edge that does not end at it", film.number(v));
    }
  }
}

// Each live edge end must be met exactly once when the rings of all vertices are walked.
void check_vertex_rings(const Film& film, Findings& findings) {
  std::vector<std::uint8_t> met(2 * std::size_t{film.edge_rows()}, 0);
  for (std::uint32_t i = 0; i < film.vertex_rows() && !findings.full(); ++i) {
    const Vertex v(i);
    if (!film.alive(v) || !film.first_end(v).valid()) continue;
    EdgeEnd end = film.first_end(v);
    do {
      if (!end.valid() || end.edge().index >= film.edge_rows() || film.at(end) != v || met[end.code] != 0) {
        findings.add("the ring of edges around vertex {} is broken", film.number(v));
        break;
      }
      met[end.code] = 1;
      end = film.next_around(end);
    } while (end != film.first_end(v));
  }
  for (std::uint32_t i = 0; i < film.edge_rows() && !findings.full(); ++i) {
    const Edge e(i);
    if (!film.alive(e)) continue;
    if (met[2 * std::size_t{i}] == 0 || met[2 * std::size_t{i} + 1] == 0) {
      findings.add("edge {} is missing from the ring of one of its ends", film.number(e));
    }
  }
}

void check_triangles(const Film& film, Findings& findings) {
  for (std::uint32_t i = 0; i < film.triangle_rows() && !findings.full(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const auto& corner = film.corners(t);
    const bool repeated = corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
    if (repeated && !film.periodic()) {
      findings.add("facet {} has a corner twice", film.number(t));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const SignedEdge e = film.edges(t)[k];
      if (!e.valid() || !film.alive(e.edge())) {
        findings.add("facet {} refers to a removed edge", film.number(t));
      } else if (film.tail(e) != corner[k] || film.head(e) != corner[(k + 1) % 3]) {
        findings.add("edge {} of facet {} does not join its corners", film.number(e.edge()), film.number(t));
      }
    }
  }
}

// Whoever walks around a facet comes back to where they began, not to an image of it.
void check_wraps(const Film& film, Findings& findings) {
  for (std::uint32_t i = 0; i < film.triangle_rows() && !findings.full(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const Wrap around = film.corner_wraps(t)[2] + film.wrap(film.edges(t)[2]);
    if (around != Wrap{}) findings.add("the wraps around facet {} do not cancel", film.number(t));
  }
}

// Each live side must be met exactly once when the rings of all edges are walked.
void check_edge_rings(const Film& film, Findings& findings) {
  std::vector<std::uint8_t> met(3 * std::size_t{film.triangle_rows()}, 0);
  for (std::uint32_t i = 0; i < film.edge_rows() && !findings.full(); ++i) {
    const Edge e(i);
    if (!film.alive(e)) continue;
    // In a periodic film an edge may lead to the image of its own end.
    if (film.ends(e)[0] == film.ends(e)[1] && !film.periodic())
      findings.add("edge {} ends where it begins", film.number(e));
    const Side first = film.first_side(e);
    if (!first.valid()) continue;
    Side s = first;
    do {
      if (!s.valid() || !film.alive(s.triangle()) || film.edge_of(s).edge() != e || met[s.index] != 0) {
        findings.add("the ring of facets around edge {} is broken", film.number(e));
        break;
      }
      met[s.index] = 1;
      s = film.next_around(s);
    } while (s != first);
  }
  for (std::uint32_t i = 0; i < film.triangle_rows() && !findings.full(); ++i) {
    if (!film.alive(Triangle(i))) continue;
    for (int k = 0; k < 3; ++k) {
      if (met[Side(Triangle(i), k).index] == 0) {
        findings.add("facet {} is missing from the ring of one of its edges", film.number(Triangle(i)));
      }
    }
  }
}

// The turn from one apex direction to the next about the edge's axis, in [0, 2 pi).
double turn(const Vec3& axis, const Vec3& from, const Vec3& to) {
  const double angle =
      std::atan2(dot(cross(from, to), axis), dot(from, to) - dot(from, axis) * dot(to, axis));
  return angle < 0 ? angle + 2 * M_PI : angle;
}

// Sides in cyclic order turn by one full circle in all; any other order turns by two or more.
void check_side_order(const Film& film, Findings& findings) {
  for (std::uint32_t i = 0; i < film.edge_rows() && !findings.full(); ++i) {
    const Edge e(i);
    if (!film.alive(e) || film.valence(e) < 3) continue;
    const Vec3 axis = unit(film.vector(e));
    double total = 0;
    film.for_each_side(e, [&](Side s) {
      total += turn(axis, apex_direction(film, s), apex_direction(film, film.next_around(s)));
    });
    if (total > 3 * M_PI) {
      findings.add("the facets around edge {} are not in geometric order (sheets may have crossed there)",
                   film.number(e));
    }
  }
}

}  // namespace

std::vector<std::string> check(const Film& film, std::size_t most) {
  Findings findings(most);
  check_sizes(film, findings);
  if (findings.full()) return findings.take();
  check_counts(film, findings);
  check_vertices(film, findings);
  check_vertex_rings(film, findings);
  check_triangles(film, findings);
  check_edge_rings(film, findings);
  if (film.periodic() && !findings.full()) check_wraps(film, findings);
  std::vector<std::string> found = findings.take();
  if (!found.empty()) return found;  // geometry is meaningless on broken connectivity
  Findings geometric(most);
  check_side_order(film, geometric);
  return geometric.take();
}

std::vector<std::string> check_regions(const Film& film, std::size_t most) {
  Findings findings(most);
  for (std::uint32_t i = 0; i < film.edge_rows() && !findings.full(); ++i) {
    const Edge e(i);
    if (!film.alive(e)) continue;
    film.for_each_side(e, [&](Side s) {
      const Side next = film.next_around(s);
      if (film.region_after(s) == film.region_before(next)) return;
      findings.add("between facets {} and {} around edge {} lie two bodies at once ({} and {})",
                   film.number(s.triangle()), film.number(next.triangle()), film.number(e),
                   film.region_after(s).index, film.region_before(next).index);
    });
  }
  return findings.take();
}

}  // namespace lamella::film
