#include "energy/edge_integral.h"

#include <array>
#include <cmath>
#include <cstdlib>

#include "scene/constraint_sets.h"
#include "scene/projection.h"

namespace lamella::energy {

using film::Edge;
using film::ElementKind;
using scene::EdgeIntegrand;

namespace {

struct GaussPoint {
  double at = 0.5;
  double weight = 1;
};

// Gauss and Legendre's points on [0, 1]: n of them are exact up to degree 2n-1. Roots of the Legendre
// polynomial by Newton's method.
std::vector<GaussPoint> gauss_points(int order) {
  const int n = std::max(1, (order + 2) / 2);
  std::vector<GaussPoint> points;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(M_PI * (i + 0.75) / (n + 0.5));
    double slope = 1;
    for (int step = 0; step < 100; ++step) {
      double p0 = 1;
      double p1 = x;
      for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      slope = n * (x * p1 - p0) / (x * x - 1);
      const double change = p1 / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    points.push_back({0.5 * (1 - x), 1 / ((1 - x * x) * slope * slope)});
  }
  return points;
}

const std::vector<GaussPoint>& rule(int order) {
  static thread_local std::vector<std::vector<GaussPoint>> rules;
  const auto row = static_cast<std::size_t>(std::max(1, order));
  if (rules.size() <= row) rules.resize(row + 1);
  if (rules[row].empty()) rules[row] = gauss_points(order);
  return rules[row];
}

// Sums of a level set's or boundary's fields over an element's constraints.
template <class Function>
void for_each_field(const scene::Scene& scene, Edge e, bool content, Function&& function) {
  for (const int number : scene::constraints_of(scene, ElementKind::edge, e.index)) {
    const auto at = scene.level_sets.find(std::abs(number));
    if (at == scene.level_sets.end()) continue;
    const auto& field = content ? at->second.content : at->second.energy;
    if (field) function(*field, number < 0 ? -1.0 : 1.0);
  }
  const auto boundary = scene.boundaries.find(scene::boundary_of(scene, ElementKind::edge, e.index));
  if (boundary == scene.boundaries.end()) return;
  const auto& field = content ? boundary->second.content : boundary->second.energy;
  // By the convention of datafiles, contents of boundaries count with the opposite sign.
  if (field) function(*field, content ? -1.0 : 1.0);
}

bool any_field(const scene::Scene& scene, bool content) {
  for (const auto& [number, set] : scene.level_sets) {
    if (content ? set.content.has_value() : set.energy.has_value()) return true;
  }
  for (const auto& [number, boundary] : scene.boundaries) {
    if (content ? boundary.content.has_value() : boundary.energy.has_value()) return true;
  }
  return false;
}

}  // namespace

namespace {

// Calls function(axis, formula, attributes) for the components of a field that are there.
template <class Function>
void for_each_component(const FieldEdge& edge, Function&& function) {
  std::span<const double> left = edge.attributes;
  for (int axis = 0; axis < 3; ++axis) {
    const language::Formula& formula = (*edge.field)[static_cast<std::size_t>(axis)];
    if (!formula) continue;
    const std::size_t read = formula.attributes().size();
    function(axis, formula, left.first(read));
    left = left.subspan(read);
  }
}

FieldEdge field_edge(const scene::Scene& scene, const EdgeIntegrand& field, Edge e, double times,
                     film::Region region) {
  FieldEdge edge{&field, scene.film.ends(e)[0], scene.film.ends(e)[1], times, region};
  if (scene.film.periodic()) edge.shift_to = scene.film.lattice()->shift(scene.film.wrap({e, false}));
  for (const language::Formula& formula : field) {
    const std::vector<double> values = scene::attributes_of(scene.film, formula, ElementKind::edge, e.index);
    edge.attributes.insert(edge.attributes.end(), values.begin(), values.end());
  }
  return edge;
}

}  // namespace

namespace {

bool of_ends(const FieldEdge& edge) {
  return edge.at_from || edge.at_to;
}

std::array<double, 3> place_of(std::span<const Vec3> positions, film::Vertex v, const Vec3& shift) {
  const Vec3 p = positions[v.index] + shift;
  return {p.x, p.y, p.z};
}

EdgeGradient ends_gradient(const FieldEdge& edge, std::span<const Vec3> positions, double time) {
  EdgeGradient result;
  const auto add = [&](film::Vertex v, const Vec3& shift, double times, Vec3& gradient) {
    const std::array<double, 3> at = place_of(positions, v, shift);
    const language::Jet jet = (*edge.field)[0].gradient({at, time, edge.attributes});
    result.value += times * jet.value;
    gradient = times * Vec3{jet.gradient[0], jet.gradient[1], jet.gradient[2]};
  };
  if (edge.at_from) add(edge.from, edge.shift_from, -edge.times, result.from);
  if (edge.at_to) add(edge.to, edge.shift_to, edge.times, result.to);
  return result;
}

EdgeHessian ends_hessian(const FieldEdge& edge, std::span<const Vec3> positions, double time) {
  EdgeHessian result;
  const auto block = [&](film::Vertex v, const Vec3& shift, double times) {
    const std::array<double, 3> at = place_of(positions, v, shift);
    return times * film::symmetric((*edge.field)[0].hessian({at, time, edge.attributes}).hessian);
  };
  if (edge.at_from) result.from_from = block(edge.from, edge.shift_from, -edge.times);
  if (edge.at_to) result.to_to = block(edge.to, edge.shift_to, edge.times);
  return result;
}

}  // namespace

double edge_integral(const FieldEdge& edge, std::span<const Vec3> positions, double time, int order) {
  if (of_ends(edge)) return ends_gradient(edge, positions, time).value;
  const Vec3 from = positions[edge.from.index] + edge.shift_from;
  const Vec3 d = positions[edge.to.index] + edge.shift_to - from;
  double sum = 0;
  for (const GaussPoint& point : rule(order)) {
    const Vec3 p = from + point.at * d;
    const std::array<double, 3> at{p.x, p.y, p.z};
    for_each_component(edge, [&](int axis, const language::Formula& f, std::span<const double> attributes) {
      sum += point.weight * d[axis] * f.value({at, time, attributes});
    });
  }
  return edge.times * sum;
}

EdgeGradient edge_integral_gradient(const FieldEdge& edge, std::span<const Vec3> positions, double time,
                                    int order) {
  if (of_ends(edge)) return ends_gradient(edge, positions, time);
  const Vec3 from = positions[edge.from.index] + edge.shift_from;
  const Vec3 d = positions[edge.to.index] + edge.shift_to - from;
  EdgeGradient result;
  for (const GaussPoint& point : rule(order)) {
    const Vec3 p = from + point.at * d;
    const std::array<double, 3> at{p.x, p.y, p.z};
    const double weight = edge.times * point.weight;
    for_each_component(edge, [&](int axis, const language::Formula& f, std::span<const double> attributes) {
      const language::Jet jet = f.gradient({at, time, attributes});
      result.value += weight * d[axis] * jet.value;
      const Vec3 slope = (weight * d[axis]) * Vec3{jet.gradient[0], jet.gradient[1], jet.gradient[2]};
      result.from += (1 - point.at) * slope;
      result.to += point.at * slope;
      result.from[axis] -= weight * jet.value;
      result.to[axis] += weight * jet.value;
    });
  }
  return result;
}

// With p = from + s d on the edge d = to - from, G the field's Jacobian there and S the sum of d_i times the
// Hessian of component i, the second variation by (a, b) is 2 (b-a)^T G p' + p'^T S p', p' = (1-s) a + s b.
EdgeHessian edge_integral_hessian(const FieldEdge& edge, std::span<const Vec3> positions, double time,
                                  int order) {
  if (of_ends(edge)) return ends_hessian(edge, positions, time);
  const Vec3 from = positions[edge.from.index] + edge.shift_from;
  const Vec3 d = positions[edge.to.index] + edge.shift_to - from;
  EdgeHessian result;
  for (const GaussPoint& point : rule(order)) {
    const double s = point.at;
    const double weight = edge.times * point.weight;
    const Vec3 p = from + s * d;
    const std::array<double, 3> at{p.x, p.y, p.z};
    film::Mat3 jacobian;
    film::Mat3 bend;
    std::array<Vec3*, 3> row{&jacobian.x, &jacobian.y, &jacobian.z};
    for_each_component(edge, [&](int axis, const language::Formula& f, std::span<const double> attributes) {
      const language::Jet jet = f.hessian({at, time, attributes});
      *row[static_cast<std::size_t>(axis)] = {jet.gradient[0], jet.gradient[1], jet.gradient[2]};
      bend += d[axis] * film::symmetric(jet.hessian);
    });
    const film::Mat3 turned = transposed(jacobian);
    result.from_from += weight * ((1 - s) * (1 - s) * bend - (1 - s) * (jacobian + turned));
    result.to_to += weight * (s * s * bend + s * (jacobian + turned));
    result.from_to += weight * (s * (1 - s) * bend + (1 - s) * turned - s * jacobian);
  }
  return result;
}

namespace {

// Calls function(field, sign) for what the constraints of a vertex give where films are of one dimension.
template <class Function>
void for_each_end_field(const scene::Scene& scene, film::Vertex v, bool content, Function&& function) {
  for (const int number : scene::constraints_of(scene, ElementKind::vertex, v.index)) {
    const auto at = scene.level_sets.find(std::abs(number));
    if (at == scene.level_sets.end()) continue;
    const auto& field = content ? at->second.content : at->second.energy;
    if (field && (*field)[0]) function(*field, number < 0 ? -1.0 : 1.0);
  }
  const auto boundary = scene.boundaries.find(scene::boundary_of(scene, ElementKind::vertex, v.index));
  if (boundary == scene.boundaries.end()) return;
  const auto& field = content ? boundary->second.content : boundary->second.energy;
  if (field && (*field)[0]) function(*field, 1.0);
}

// Calls function(edge, region, times, shift) for the edges of each cell and the regions behind it and, with a
// minus, in front; `shift` brings the edge to where the cell lies in a periodic film.
template <class Function>
void for_each_cell_edge(const scene::Scene& scene, Function&& function) {
  const auto loops = scene::loops_of_cells(scene);
  for (std::size_t cell = 0; cell < loops.size(); ++cell) {
    const film::RegionPair pair = scene.strings.cells[cell].regions;
    film::Wrap place;
    for (const film::SignedEdge e : loops[cell]) {
      Vec3 shift;
      if (scene.film.periodic()) {
        const film::Wrap next = place + scene.film.wrap(e);
        shift = scene.film.lattice()->shift(e.reversed() ? next : place);
        place = next;
      }
      const double along = e.reversed() ? -1 : 1;
      if (!pair.behind.outside()) function(e.edge(), pair.behind, along, shift);
      if (!pair.front.outside()) function(e.edge(), pair.front, -along, shift);
    }
  }
}

void move(FieldEdge& edge, const Vec3& shift) {
  edge.shift_from += shift;
  edge.shift_to += shift;
}

std::vector<FieldEdge> string_content_edges(const scene::Scene& scene) {
  std::vector<FieldEdge> edges;
  for_each_cell_edge(scene, [&](Edge e, film::Region region, double along, const Vec3& shift) {
    edges.push_back(field_edge(scene, scene.strings.area, e, along, region));
    move(edges.back(), shift);
    for (const bool head : {false, true}) {
      const film::Vertex v = scene.film.ends(e)[head ? 1 : 0];
      for_each_end_field(scene, v, true, [&](const EdgeIntegrand& field, double times) {
        FieldEdge at_end{&field, scene.film.ends(e)[0], scene.film.ends(e)[1], along * times, region};
        (head ? at_end.at_to : at_end.at_from) = true;
        edges.push_back(at_end);
      });
    }
  });
  return edges;
}

// Weights of bodies, and what constraints give their vertices.
std::vector<FieldEdge> string_energy_edges(const scene::Scene& scene) {
  std::vector<FieldEdge> edges;
  const double gravity = scene::present_gravity(scene);
  for_each_cell_edge(scene, [&](Edge e, film::Region region, double along, const Vec3& shift) {
    const double weight = gravity * scene.body(region).density;
    if (weight == 0) return;
    edges.push_back(field_edge(scene, scene.strings.height, e, along * weight, {}));
    move(edges.back(), shift);
  });
  for (std::uint32_t i = 0; i < scene.film.vertex_rows(); ++i) {
    const film::Vertex v(i);
    if (!scene.film.alive(v)) continue;
    for_each_end_field(scene, v, false, [&](const EdgeIntegrand& field, double times) {
      FieldEdge at_vertex{&field, v, v, times, {}};
      at_vertex.at_to = true;
      edges.push_back(at_vertex);
    });
  }
  return edges;
}

}  // namespace

std::vector<FieldEdge> energy_edges(const scene::Scene& scene) {
  if (scene.strings.on) return string_energy_edges(scene);
  std::vector<FieldEdge> edges;
  if (!any_field(scene, false)) return edges;
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    const Edge e(i);
    if (!scene.film.alive(e)) continue;
    for_each_field(scene, e, false, [&](const EdgeIntegrand& field, double times) {
      edges.push_back(field_edge(scene, field, e, times, {}));
    });
  }
  return edges;
}

std::vector<FieldEdge> content_edges(const scene::Scene& scene) {
  if (scene.strings.on) return string_content_edges(scene);
  std::vector<FieldEdge> edges;
  if (!any_field(scene, true)) return edges;
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    const Edge e(i);
    if (!scene.film.alive(e)) continue;
    for_each_field(scene, e, true, [&](const EdgeIntegrand& field, double times) {
      const auto add = [&](film::Region region, double sign) {
        if (!region.outside()) edges.push_back(field_edge(scene, field, e, sign, region));
      };
      scene.film.for_each_side(e, [&](film::Side s) {
        const double along = scene.film.edge_of(s).reversed() ? -times : times;
        const film::RegionPair pair = scene.film.regions(s.triangle());
        if (pair.behind == pair.front) return;
        add(pair.behind, along);
        add(pair.front, -along);
      });
    });
  }
  return edges;
}

}  // namespace lamella::energy
