// Functions of the positions of one, two or three vertices with their derivatives, and how they combine: from
// a length or an area and a mean over Gauss points, the integrals of named quantities.
#pragma once

#include <array>
#include <span>

#include "film/mat3.h"
#include "language/formula.h"

namespace lamella::energy {

using film::Mat3;
using film::Vec3;

// Corners that an element lacks have zeros.
struct ElementJet {
  double value = 0;
  std::array<Vec3, 3> gradient{};
  std::array<std::array<Mat3, 3>, 3> hessian{};  // block [i][j] = d2/d(corner i)d(corner j), all of them
};

// Up to which derivatives a jet is wanted; higher ones stay zero.
enum class Order : std::uint8_t { value, gradient, hessian };

ElementJet product(const ElementJet& a, const ElementJet& b, Order order);
void add(ElementJet& to, double factor, const ElementJet& jet);

// A component of the vector from corner 0 to corner 1.
ElementJet edge_component(std::span<const Vec3> corners, int axis);
ElementJet edge_length_jet(std::span<const Vec3> corners, Order order);
// A component of the vector area.
ElementJet area_component(std::span<const Vec3> corners, int axis);
ElementJet area_jet(std::span<const Vec3> corners, Order order);

// A point in an element: a mean of the corners with these weights, and its weight in a sum of total weight 1.
struct GaussPoint {
  std::array<double, 3> corner{};
  double weight = 1;
};

// Points that integrate polynomials up to a degree exactly, over an edge and over a triangle.
std::span<const GaussPoint> edge_points(int degree);
std::span<const GaussPoint> triangle_points(int degree);

// A formula as an element evaluates it.
struct Integrand {
  const language::Formula* formula = nullptr;
  double time = 0;
  std::span<const double> attributes;
};

// The mean of a function over an element.
ElementJet mean_jet(const Integrand& f, std::span<const Vec3> corners, std::span<const GaussPoint> points,
                    Order order);

// The mean of a function of position and area vector over a triangle.
ElementJet general_jet(const Integrand& f, std::span<const Vec3> corners, std::span<const GaussPoint> points,
                       Order order);

}  // namespace lamella::energy
