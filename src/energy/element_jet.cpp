#include "energy/element_jet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "energy/triangle_hessian.h"

namespace lamella::energy {

ElementJet product(const ElementJet& a, const ElementJet& b, Order order) {
  ElementJet r;
  r.value = a.value * b.value;
  if (order == Order::value) return r;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = a.value * b.gradient[i] + b.value * a.gradient[i];
  if (order == Order::gradient) return r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r.hessian[i][j] = a.value * b.hessian[i][j] + b.value * a.hessian[i][j] +
                        outer(a.gradient[i], b.gradient[j]) + outer(b.gradient[i], a.gradient[j]);
    }
  }
  return r;
}

void add(ElementJet& to, double factor, const ElementJet& jet) {
  to.value += factor * jet.value;
  for (std::size_t i = 0; i < 3; ++i) {
    to.gradient[i] += factor * jet.gradient[i];
    for (std::size_t j = 0; j < 3; ++j) to.hessian[i][j] += factor * jet.hessian[i][j];
  }
}

// --- lengths and areas

namespace {

Vec3 axis_vector(int axis) {
  Vec3 v;
  v[axis] = 1;
  return v;
}

// The edge opposite to corner i, run counterclockwise.
Vec3 opposite(std::span<const Vec3> corners, std::size_t i) {
  return corners[(i + 2) % 3] - corners[(i + 1) % 3];
}

}  // namespace

ElementJet edge_component(std::span<const Vec3> corners, int axis) {
  ElementJet jet;
  jet.value = corners[1][axis] - corners[0][axis];
  jet.gradient[0] = -axis_vector(axis);
  jet.gradient[1] = axis_vector(axis);
  return jet;
}

ElementJet edge_length_jet(std::span<const Vec3> corners, Order order) {
  ElementJet jet;
  const Vec3 d = corners[1] - corners[0];
  jet.value = length(d);
  jet.gradient[1] = unit(d);
  jet.gradient[0] = -jet.gradient[1];
  if (order != Order::hessian) return jet;
  const Mat3 h = edge_length_hessian(corners[0], corners[1]);
  jet.hessian[0][0] = jet.hessian[1][1] = h;
  jet.hessian[0][1] = jet.hessian[1][0] = -1 * h;
  return jet;
}

// The vector area is half the sum of the products of each corner with the next; moving corner i by v turns it
// by e_i x v / 2 with the opposite edge e_i.
ElementJet area_component(std::span<const Vec3> corners, int axis) {
  ElementJet jet;
  const Vec3 k = axis_vector(axis);
  jet.value = 0.5 * double_area_vector(corners[0], corners[1], corners[2])[axis];
  const Mat3 turn = film::cross_matrix(0.5 * k);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    jet.gradient[i] = 0.5 * cross(k, opposite(corners, i));
    jet.hessian[i][next] = -1 * turn;
    jet.hessian[next][i] = turn;
  }
  return jet;
}

ElementJet area_jet(std::span<const Vec3> corners, Order order) {
  ElementJet jet;
  jet.value = triangle_area(corners[0], corners[1], corners[2]);
  if (order == Order::value) return jet;
  jet.gradient = triangle_area_gradient(corners[0], corners[1], corners[2]);
  if (order == Order::hessian) jet.hessian = triangle_area_hessian(corners[0], corners[1], corners[2]);
  return jet;
}

// --- points

namespace {

// Gauss and Legendre's rule on [0, 1] with n points: roots of the Legendre polynomial by Newton's method.
std::vector<std::array<double, 2>> legendre(int n) {
  std::vector<std::array<double, 2>> points;
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

std::vector<GaussPoint> edge_rule(int degree) {
  std::vector<GaussPoint> points;
  for (const auto& [at, weight] : legendre(std::max(1, (degree + 2) / 2)))
    points.push_back({{1 - at, at, 0}, weight});
  return points;
}

// Radon's seven points, exact to degree 5.
std::vector<GaussPoint> radon_rule() {
  std::vector<GaussPoint> points{{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 9.0 / 40}};
  for (const double sign : {-1.0, 1.0}) {
    const double near = (6 + sign * std::sqrt(15.0)) / 21;
    const double weight = (155 + sign * std::sqrt(15.0)) / 1200;
    for (std::size_t i = 0; i < 3; ++i) {
      GaussPoint point{{near, near, near}, weight};
      point.corner[i] = 1 - 2 * near;
      points.push_back(point);
    }
  }
  return points;
}

// For higher degrees, rules of lines over lines that run together in a corner.
std::vector<GaussPoint> conical_rule(int degree) {
  const auto line = legendre(degree / 2 + 2);
  std::vector<GaussPoint> points;
  for (const auto& [u, weight_u] : line) {
    for (const auto& [v, weight_v] : line)
      points.push_back({{u, (1 - u) * v, (1 - u) * (1 - v)}, 2 * (1 - u) * weight_u * weight_v});
  }
  return points;
}

std::vector<GaussPoint> triangle_rule(int degree) {
  if (degree <= 1) return {{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 1}};
  return degree <= 5 ? radon_rule() : conical_rule(degree);
}

std::span<const GaussPoint> remembered(std::vector<std::vector<GaussPoint>>& rules, int degree,
                                       std::vector<GaussPoint> (*rule)(int)) {
  const auto row = static_cast<std::size_t>(std::max(0, degree));
  if (rules.size() <= row) rules.resize(row + 1);
  if (rules[row].empty()) rules[row] = rule(degree);
  return rules[row];
}

}  // namespace

std::span<const GaussPoint> edge_points(int degree) {
  static thread_local std::vector<std::vector<GaussPoint>> rules;
  return remembered(rules, degree, edge_rule);
}

std::span<const GaussPoint> triangle_points(int degree) {
  static thread_local std::vector<std::vector<GaussPoint>> rules;
  return remembered(rules, degree, triangle_rule);
}

// --- means

namespace {

Vec3 point_of(std::span<const Vec3> corners, const GaussPoint& point) {
  Vec3 p;
  for (std::size_t i = 0; i < corners.size(); ++i) p += point.corner[i] * corners[i];
  return p;
}

Mat3 matrix_of(const std::array<double, 6>& h) {
  return {{h[0], h[1], h[2]}, {h[1], h[3], h[4]}, {h[2], h[4], h[5]}};
}

}  // namespace

ElementJet mean_jet(const Integrand& f, std::span<const Vec3> corners, std::span<const GaussPoint> points,
                    Order order) {
  ElementJet jet;
  const std::size_t n = corners.size();
  for (const GaussPoint& point : points) {
    const Vec3 p = point_of(corners, point);
    const std::array<double, 3> at{p.x, p.y, p.z};
    const language::FormulaInputs inputs{at, f.time, f.attributes};
    if (order == Order::value) {
      jet.value += point.weight * f.formula->value(inputs);
      continue;
    }
    const language::Jet local =
        order == Order::hessian ? f.formula->hessian(inputs) : f.formula->gradient(inputs);
    jet.value += point.weight * local.value;
    const Vec3 slope = point.weight * Vec3{local.gradient[0], local.gradient[1], local.gradient[2]};
    for (std::size_t i = 0; i < n; ++i) jet.gradient[i] += point.corner[i] * slope;
    if (order != Order::hessian) continue;
    const Mat3 curvature = point.weight * matrix_of(local.hessian);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        jet.hessian[i][j] += (point.corner[i] * point.corner[j]) * curvature;
    }
  }
  return jet;
}

namespace {

constexpr std::size_t arguments = 6;  // position and area vector

struct SixJet {
  double value = 0;
  std::array<double, arguments> gradient{};
  std::array<std::array<double, arguments>, arguments> hessian{};
};

// Formulas know their derivatives by three arguments at a time, so the pairs are covered by such triples.
SixJet six_jet(const Integrand& f, const std::array<double, arguments>& at, Order order) {
  constexpr std::array<std::array<int, 3>, 7> triples = {
      {{0, 1, 2}, {3, 4, 5}, {0, 3, 4}, {1, 3, 4}, {2, 3, 4}, {0, 1, 5}, {2, 5, 0}}};
  SixJet jet;
  const std::size_t passes = order == Order::hessian ? triples.size() : 2;
  for (std::size_t pass = 0; pass < passes; ++pass) {
    const language::FormulaInputs inputs{at, f.time, f.attributes, triples[pass]};
    const language::Jet local =
        order == Order::hessian ? f.formula->hessian(inputs) : f.formula->gradient(inputs);
    jet.value = local.value;
    const Mat3 h = matrix_of(local.hessian);
    const std::array<Vec3, 3> rows{h.x, h.y, h.z};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto i = static_cast<std::size_t>(triples[pass][a]);
      jet.gradient[i] = local.gradient[a];
      for (std::size_t b = 0; b < 3; ++b)
        jet.hessian[i][static_cast<std::size_t>(triples[pass][b])] = rows[a][static_cast<int>(b)];
    }
  }
  return jet;
}

}  // namespace

ElementJet general_jet(const Integrand& f, std::span<const Vec3> corners, std::span<const GaussPoint> points,
                       Order order) {
  ElementJet result;
  std::array<ElementJet, arguments> argument;
  for (int axis = 0; axis < 3; ++axis)
    argument[3 + static_cast<std::size_t>(axis)] = area_component(corners, axis);
  for (const GaussPoint& point : points) {
    const Vec3 p = point_of(corners, point);
    std::array<double, arguments> at{};
    for (int axis = 0; axis < 3; ++axis) {
      ElementJet& position = argument[static_cast<std::size_t>(axis)];
      position = {};
      position.value = p[axis];
      for (std::size_t i = 0; i < 3; ++i) position.gradient[i] = point.corner[i] * axis_vector(axis);
    }
    for (std::size_t k = 0; k < arguments; ++k) at[k] = argument[k].value;
    const SixJet local = six_jet(f, at, order);
    result.value += point.weight * local.value;
    if (order == Order::value) continue;
    for (std::size_t k = 0; k < arguments; ++k) {
      ElementJet part = argument[k];
      part.value = 0;
      add(result, point.weight * local.gradient[k], part);
    }
    if (order != Order::hessian) continue;
    for (std::size_t k = 0; k < arguments; ++k) {
      for (std::size_t l = 0; l < arguments; ++l) {
        const double second = point.weight * local.hessian[k][l];
        if (second == 0) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j)
            result.hessian[i][j] += second * outer(argument[k].gradient[i], argument[l].gradient[j]);
        }
      }
    }
  }
  return result;
}

}  // namespace lamella::energy
