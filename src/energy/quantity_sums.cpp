#include "energy/quantity_sums.h"

#include <algorithm>
#include <cmath>

#include "scene/constraint_sets.h"
#include "scene/projection.h"

namespace lamella::energy {

namespace {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vertex;
using scene::Method;
using scene::MethodInstance;

std::uint32_t rows_of(const Film& film, ElementKind kind) {
  return kind == ElementKind::vertex ? film.vertex_rows()
         : kind == ElementKind::edge ? film.edge_rows()
                                     : film.triangle_rows();
}

bool is_alive(const Film& film, ElementKind kind, std::uint32_t row) {
  return kind == ElementKind::vertex ? film.alive(Vertex(row))
         : kind == ElementKind::edge ? film.alive(Edge(row))
                                     : film.alive(Triangle(row));
}

std::array<Vertex, 3> corners_of(const Film& film, const film::Unfolding& unfolding, ElementKind kind,
                                 std::uint32_t row) {
  if (kind == ElementKind::vertex) return {Vertex(row), Vertex(row), Vertex(row)};
  if (kind == ElementKind::facet)
    return unfolding.empty() ? film.corners(Triangle(row)) : unfolding.triangles()[row];
  const auto& ends = unfolding.empty() ? film.ends(Edge(row)) : unfolding.edges()[row];
  return {ends[0], ends[1], ends[1]};
}

// How often an instance is taken of an element: 0, 1, or -1 where it counts turned over.
class Membership {
 public:
  Membership(const scene::Scene& scene, const scene::Quantity& quantity, const MethodInstance& instance)
      : global_(instance.global) {
    const film::Columns& columns = scene.film.columns(scene::element_of(instance.method));
    mark_ = columns.find(scene::membership_column(instance.name.empty() ? quantity.name : instance.name));
    turned_ = columns.find("orientation");
    oriented_ = scene::is_oriented(instance.method);
  }

  double times(std::uint32_t row) const {
    if (!global_ && (mark_ == nullptr || mark_->value(row) == 0)) return 0;
    return oriented_ && turned_ != nullptr && turned_->value(row) < 0 ? -1 : 1;
  }

 private:
  const film::Column* mark_ = nullptr;
  const film::Column* turned_ = nullptr;
  bool global_ = false;
  bool oriented_ = false;
};

// The directions that walls forbid at a vertex: the film goes on behind them as in a mirror.
std::vector<Vec3> mirrors_at(const scene::Scene& scene, std::uint32_t vertex, const Vec3& position) {
  std::vector<Vec3> mirrors;
  for (const int number : scene::constraints_of(scene, ElementKind::vertex, vertex)) {
    const auto at = scene.level_sets.find(std::abs(number));
    if (at == scene.level_sets.end() || at->second.nonwall) continue;
    mirrors.push_back(scene::level_at(scene, at->second, position, vertex).gradient);
  }
  mirrors.resize(static_cast<std::size_t>(scene::orthonormalise(mirrors)));
  return mirrors;
}

StarValue value_of(const VertexStar& star, Method method, std::span<const Vec3> positions) {
  return method == Method::sq_mean_curvature ? squared_curvature(star, positions)
                                             : perpendicular_squared_curvature(star, positions);
}

// The mean of z over a triangle.
ElementJet mean_height(std::span<const Vec3> corners) {
  ElementJet jet;
  for (std::size_t i = 0; i < 3; ++i) {
    jet.value += corners[i].z / 3;
    jet.gradient[i] = {0, 0, 1.0 / 3};
  }
  return jet;
}

// The mean of z^2/2 over a triangle.
ElementJet mean_moment(std::span<const Vec3> corners) {
  ElementJet jet;
  const double sum = corners[0].z + corners[1].z + corners[2].z;
  for (std::size_t i = 0; i < 3; ++i) {
    jet.value += corners[i].z * (corners[i].z + sum) / 24;
    jet.gradient[i] = {0, 0, (corners[i].z + sum) / 12};
    for (std::size_t k = 0; k < 3; ++k) jet.hessian[i][k].z.z = (i == k ? 2.0 : 1.0) / 12;
  }
  return jet;
}

// Where the total curvature of a surface is taken: what is fixed, or on a boundary, or marked for it.
bool on_boundary(const scene::Scene& scene, ElementKind kind, std::uint32_t row) {
  const film::Columns& columns = scene.film.columns(kind);
  const char* const mark = kind == ElementKind::vertex ? "gauss_bdry_v" : "gauss_bdry_e";
  if (const film::Column* const column = columns.find(mark)) return column->value(row) != 0;
  const auto fixed = columns.flags("fixed");
  return (!fixed.empty() && fixed[row] != 0) || scene::boundary_of(scene, kind, row) != 0;
}

// How much heavier it is behind a facet than in front.
double density_step(const scene::Scene& scene, Triangle t) {
  const auto density = [&](film::Region r) { return r.outside() ? 0.0 : scene.body(r).density; };
  const film::RegionPair pair = scene.film.regions(t);
  return density(pair.behind) - density(pair.front);
}

double tension_of(const scene::Scene& scene, Method method, std::uint32_t row) {
  if (method == Method::gravity_method) return density_step(scene, Triangle(row));
  if (method == Method::density_facet_area) return scene::tension(scene, Triangle(row));
  if (method != Method::density_edge_length) return 1;
  const std::span<const double> tension = scene.film.columns(ElementKind::edge).reals("tension");
  return tension.empty() ? 0 : tension[row];
}

}  // namespace

QuantitySum::QuantitySum(const scene::Scene& scene, const scene::Quantity& quantity,
                         std::span<const Vec3> positions, const film::Unfolding& unfolding)
    : edge_order_(scene.edge_integral_order),
      facet_order_(scene.facet_integral_order),
      constant_(quantity.modulus * quantity.constant) {
  for (const MethodInstance& instance : quantity.methods)
    collect(scene, quantity, instance, positions, unfolding);
}

void QuantitySum::collect(const scene::Scene& scene, const scene::Quantity& quantity,
                          const MethodInstance& instance, std::span<const Vec3> positions,
                          const film::Unfolding& unfolding) {
  const ElementKind kind = scene::element_of(instance.method);
  const Membership membership(scene, quantity, instance);
  const film::Column* const weight =
      instance.element_modulus.empty() ? nullptr : scene.film.columns(kind).find(instance.element_modulus);
  const bool of_stars =
      instance.method == Method::sq_mean_curvature || instance.method == Method::star_perp_sq_mean_curvature;
  const bool of_angles = instance.method == Method::mean_curvature_integral ||
                         instance.method == Method::gauss_curvature_integral ||
                         instance.method == Method::star_gauss_curvature;
  Part part;
  part.instance = &instance;
  part.corners = kind == ElementKind::vertex ? 1 : kind == ElementKind::edge ? 2 : 3;
  for (std::uint32_t row = 0; row < rows_of(scene.film, kind); ++row) {
    if (!is_alive(scene.film, kind, row)) continue;
    double factor = membership.times(row) * quantity.modulus * instance.modulus;
    if (weight != nullptr) factor *= weight->value(row);
    factor *= tension_of(scene, instance.method, row);
    if (factor == 0) continue;
    if (of_angles) {
      collect_angles(scene, instance.method, row, factor, unfolding);
      continue;
    }
    if (of_stars) {
      stars_.push_back({star_of(scene.film, unfolding, Vertex(row)), instance.method, factor});
      if (instance.method == Method::star_perp_sq_mean_curvature)
        stars_.back().star.mirrors = mirrors_at(scene, row, positions[row]);
      continue;
    }
    part.elements.push_back({corners_of(scene.film, unfolding, kind, row), factor,
                             static_cast<std::uint32_t>(part.attributes.size())});
    for (const language::Formula* formula :
         {&instance.scalar, &instance.field[0], &instance.field[1], &instance.field[2]}) {
      const std::vector<double> values = scene::attributes_of(scene.film, *formula, kind, row);
      part.attributes.insert(part.attributes.end(), values.begin(), values.end());
    }
  }
  if (!part.elements.empty()) parts_.push_back(std::move(part));
}

void QuantitySum::collect_angles(const scene::Scene& scene, Method method, std::uint32_t row, double factor,
                                 const film::Unfolding& unfolding) {
  const Film& film = scene.film;
  if (method == Method::mean_curvature_integral) return angles_.add_edge(film, unfolding, Edge(row), factor);
  const auto rows_of_facet = [&](Triangle t) {
    return unfolding.empty() ? film.corners(t) : unfolding.triangles()[t.index];
  };
  if (method == Method::star_gauss_curvature) {
    angles_.add_constant(2 * M_PI * factor);
    film.for_each_end(Vertex(row), [&](film::EdgeEnd end) {
      film.for_each_side(end.edge(), [&](film::Side s) {
        if (film.tail(film.edge_of(s)) == Vertex(row))
          angles_.add_corner(-factor, rows_of_facet(s.triangle()), static_cast<std::size_t>(s.corner()));
      });
    });
    return;
  }
  const Triangle t(row);
  for (std::size_t k = 0; k < 3; ++k) {
    if (on_boundary(scene, ElementKind::vertex, film.corners(t)[k].index))
      angles_.add_corner(factor, rows_of_facet(t), k);
    if (on_boundary(scene, ElementKind::edge, film.edges(t)[k].edge().index))
      angles_.add_constant(-M_PI * factor);
  }
}

ElementJet QuantitySum::jet(const Part& part, const Element& element, std::span<const Vec3> positions,
                            double time, Order order) const {
  const MethodInstance& instance = *part.instance;
  std::array<Vec3, 3> corner;
  for (std::size_t i = 0; i < part.corners; ++i) corner[i] = positions[element.corners[i].index];
  const std::span<const Vec3> corners(corner.data(), part.corners);
  std::span<const double> attributes(part.attributes);
  attributes = attributes.subspan(element.first_attribute);
  const auto integrand = [&](const language::Formula& formula) {
    const std::size_t read = formula.attributes().size();
    const Integrand f{&formula, time, attributes.first(read)};
    attributes = attributes.subspan(read);
    return f;
  };
  const std::span<const GaussPoint> points =
      part.corners == 3 ? triangle_points(facet_order_) : edge_points(edge_order_);
  const auto field = [&](ElementJet (*component)(std::span<const Vec3>, int)) {
    ElementJet sum;
    for (int axis = 0; axis < 3; ++axis) {
      const language::Formula& formula = instance.field[static_cast<std::size_t>(axis)];
      if (!formula) continue;
      add(sum, 1,
          product(component(corners, axis), mean_jet(integrand(formula), corners, points, order), order));
    }
    return sum;
  };
  constexpr GaussPoint itself{{1, 0, 0}, 1};
  switch (instance.method) {
    case Method::vertex_scalar_integral:
      return mean_jet(integrand(instance.scalar), corners, {&itself, 1}, order);
    case Method::edge_length:
    case Method::density_edge_length:
      return edge_length_jet(corners, order);
    case Method::edge_scalar_integral:
      return product(edge_length_jet(corners, order),
                     mean_jet(integrand(instance.scalar), corners, points, order), order);
    case Method::edge_vector_integral:
      return field(edge_component);
    case Method::facet_area:
    case Method::density_facet_area:
      return area_jet(corners, order);
    case Method::facet_scalar_integral:
      return product(area_jet(corners, order), mean_jet(integrand(instance.scalar), corners, points, order),
                     order);
    case Method::facet_vector_integral:
      return field(area_component);
    case Method::facet_general_integral:
      return general_jet(integrand(instance.scalar), corners, points, order);
    case Method::facet_volume:
      return product(area_component(corners, 2), mean_height(corners), order);
    case Method::gravity_method:
      return product(area_component(corners, 2), mean_moment(corners), order);
    case Method::mean_curvature_integral:
    case Method::gauss_curvature_integral:
    case Method::star_gauss_curvature:
      break;  // they are made of angles
    case Method::sq_mean_curvature:
    case Method::star_perp_sq_mean_curvature:
      break;  // they are taken of stars
  }
  return {};
}

double QuantitySum::value(std::span<const Vec3> positions, double time) const {
  double sum = constant_ + angles_.value(positions);
  for (const Part& part : parts_) {
    for (const Element& element : part.elements)
      sum += element.factor * jet(part, element, positions, time, Order::value).value;
  }
  for (const Star& star : stars_) sum += star.factor * value_of(star.star, star.method, positions).value;
  return sum;
}

double QuantitySum::size(std::span<const Vec3> positions, double time) const {
  double sum = std::abs(constant_) + std::abs(angles_.value(positions));
  for (const Part& part : parts_) {
    for (const Element& element : part.elements)
      sum += std::abs(element.factor * jet(part, element, positions, time, Order::value).value);
  }
  for (const Star& star : stars_)
    sum += std::abs(star.factor * value_of(star.star, star.method, positions).value);
  return sum;
}

double QuantitySum::add_gradient(std::span<const Vec3> positions, double time, double factor,
                                 std::span<Vec3> gradient) const {
  double sum = constant_ + angles_.add_gradient(positions, factor, gradient);
  for (const Part& part : parts_) {
    for (const Element& element : part.elements) {
      const ElementJet j = jet(part, element, positions, time, Order::gradient);
      sum += element.factor * j.value;
      for (std::size_t i = 0; i < part.corners; ++i)
        gradient[element.corners[i].index] += (factor * element.factor) * j.gradient[i];
    }
  }
  for (const Star& star : stars_) {
    const StarValue value = value_of(star.star, star.method, positions);
    const double times = factor * star.factor;
    sum += star.factor * value.value;
    gradient[star.star.vertex] += times * value.at_vertex;
    for (std::size_t t = 0; t < value.at_others.size(); ++t) {
      for (std::size_t k = 0; k < 2; ++k)
        gradient[star.star.triangles[t][k + 1]] += times * value.at_others[t][k];
    }
  }
  return sum;
}

void QuantitySum::add_hessian(std::span<const Vec3> positions, double time, double factor,
                              HessianSink& sink) const {
  for (const Part& part : parts_) {
    for (const Element& element : part.elements) {
      const ElementJet j = jet(part, element, positions, time, Order::hessian);
      const double times = factor * element.factor;
      for (std::size_t i = 0; i < part.corners; ++i) {
        for (std::size_t k = i; k < part.corners; ++k)
          sink.add(element.corners[i].index, element.corners[k].index, times * j.hessian[i][k]);
      }
    }
  }
  angles_.add_hessian(positions, factor, sink);
  for (const Star& star : stars_) {
    const auto add = star.method == Method::sq_mean_curvature ? add_squared_curvature_hessian
                                                              : add_perpendicular_squared_curvature_hessian;
    add(star.star, positions, factor * star.factor, sink);
  }
}

std::vector<std::uint32_t> QuantitySum::support() const {
  std::vector<std::uint32_t> vertices;
  for (const Part& part : parts_) {
    for (const Element& element : part.elements) {
      for (std::size_t i = 0; i < part.corners; ++i) vertices.push_back(element.corners[i].index);
    }
  }
  angles_.for_each_row([&](std::uint32_t row) { vertices.push_back(row); });
  for (const Star& star : stars_) {
    for (const auto& corners : star.star.triangles)
      vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double quantity_value(const scene::Scene& scene, std::size_t row) {
  scene::Scene bound = scene;
  scene::bind_formulas(bound);
  return quantity_value_of_bound(bound, bound.quantities[row]);
}

double quantity_value_of_bound(const scene::Scene& scene, const scene::Quantity& quantity) {
  const std::span<const Vec3> positions = scene.film.positions();
  if (!scene.film.periodic()) return QuantitySum(scene, quantity, positions, {}).value(positions, scene.time);
  const film::Unfolding unfolding(scene.film);
  std::vector<Vec3> extended;
  unfolding.extend(positions, extended);
  return QuantitySum(scene, quantity, positions, unfolding).value(extended, scene.time);
}

}  // namespace lamella::energy
