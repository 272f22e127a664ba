// Second derivatives of the curvatures of vertex_star.h.
//
// Both are functions of three sums over the star: its area A, the gradient F of that by the vertex, and the
// gradient N of the volume under it. Their second derivatives are J^T M J, with J the first derivatives of
// the sums and M the second ones of the function, and for each triangle the function's first derivatives
// times the second ones of what the triangle adds to the sums.
#include <Eigen/Core>
#include <algorithm>

#include "energy/triangle_hessian.h"
#include "energy/vertex_star.h"

namespace lamella::energy {

namespace {

// In the order A, F, N.
using Slopes = Eigen::Matrix<double, 7, 1>;
using Curvatures = Eigen::Matrix<double, 7, 7>;
using Jacobian = Eigen::Matrix<double, 7, 3>;
using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

struct Function {
  Slopes first = Slopes::Zero();
  Curvatures second = Curvatures::Zero();
};

Vector eigen(const Vec3& v) {
  return {v.x, v.y, v.z};
}
Vec3 plain(const Vector& v) {
  return {v[0], v[1], v[2]};
}
Matrix eigen(const Mat3& m) {
  Matrix result;
  result << m.x.x, m.x.y, m.x.z, m.y.x, m.y.y, m.y.z, m.z.x, m.z.y, m.z.z;
  return result;
}
Mat3 plain(const Matrix& m) {
  return {{m(0, 0), m(0, 1), m(0, 2)}, {m(1, 0), m(1, 1), m(1, 2)}, {m(2, 0), m(2, 1), m(2, 2)}};
}

// The sums and their derivatives by each vertex of the star.
struct Star {
  Star(const VertexStar& star, std::span<const Vec3> x);

  std::vector<std::uint32_t> rows;
  std::vector<std::array<std::size_t, 3>> triangles;  // places of the corners among the rows
  std::vector<Jacobian> jacobians;                    // one for each row
  Slopes sums = Slopes::Zero();
  Matrix kept = Matrix::Identity();  // what mirrors leave of a vector
};

Star::Star(const VertexStar& star, std::span<const Vec3> x)
    : rows(rows_of(star)), jacobians(rows.size(), Jacobian::Zero()) {
  for (const Vec3& mirror : star.mirrors) kept -= eigen(mirror) * eigen(mirror).transpose();
  for (const auto& corner : star.triangles) {
    const auto place = [&](std::size_t k) {
      return static_cast<std::size_t>(std::find(rows.begin(), rows.end(), corner[k]) - rows.begin());
    };
    triangles.push_back({0, place(1), place(2)});
    const std::array<Vec3, 3> p{x[corner[0]], x[corner[1]], x[corner[2]]};
    const std::array<Vec3, 3> slope = triangle_area_gradient(p[0], p[1], p[2]);
    const TriangleHessian h = triangle_area_hessian(p[0], p[1], p[2]);
    sums[0] += triangle_area(p[0], p[1], p[2]);
    sums.segment<3>(1) += kept * eigen(slope[0]);
    sums.segment<3>(4) += kept * eigen(double_area_vector(p[0], p[1], p[2]) / 6);
    for (std::size_t k = 0; k < 3; ++k) {
      Jacobian& at = jacobians[triangles.back()[k]];
      const Vec3 opposite = p[(k + 2) % 3] - p[(k + 1) % 3];
      at.row(0) += eigen(slope[k]).transpose();
      at.middleRows<3>(1) += kept * eigen(h[0][k]);
      at.middleRows<3>(4) += kept * eigen(film::cross_matrix(opposite / 6));
    }
  }
}

void add_composed(const VertexStar& star, const Star& sums, std::span<const Vec3> x, const Function& f,
                  double factor, HessianSink& sink) {
  for (std::size_t i = 0; i < sums.rows.size(); ++i) {
    for (std::size_t k = i; k < sums.rows.size(); ++k) {
      const Matrix block = sums.jacobians[i].transpose() * f.second * sums.jacobians[k];
      sink.add(sums.rows[i], sums.rows[k], plain(Matrix(factor * block)));
    }
  }
  const Vec3 by_force = plain(Vector(sums.kept * f.first.segment<3>(1)));
  const Mat3 turn = film::cross_matrix(plain(Vector(sums.kept * f.first.segment<3>(4))) / 6);
  for (std::size_t t = 0; t < star.triangles.size(); ++t) {
    const auto& corner = star.triangles[t];
    const std::array<Vec3, 3> p{x[corner[0]], x[corner[1]], x[corner[2]]};
    const TriangleHessian h = triangle_area_hessian(p[0], p[1], p[2]);
    const TriangleHessian change = triangle_area_hessian_change(p[0], p[1], p[2], by_force);
    const auto row = [&](std::size_t k) { return sums.rows[sums.triangles[t][k]]; };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      sink.add(row(i), row(i), factor * (f.first[0] * h[i][i] + change[i][i]));
      sink.add(row(i), row(next), factor * (f.first[0] * h[i][next] + change[i][next] - turn));
    }
  }
}

}  // namespace

// 3/4 F.F/A
void add_squared_curvature_hessian(const VertexStar& star, std::span<const Vec3> positions, double factor,
                                   HessianSink& sink) {
  const Star sums(star, positions);
  const double area = sums.sums[0];
  if (!(area > 0)) return;
  const Vector force = sums.sums.segment<3>(1);
  const double square = force.squaredNorm();
  Function f;
  f.first[0] = -0.75 * square / (area * area);
  f.first.segment<3>(1) = 1.5 / area * force;
  f.second(0, 0) = 1.5 * square / (area * area * area);
  f.second.block<1, 3>(0, 1) = -1.5 / (area * area) * force.transpose();
  f.second.block<3, 1>(1, 0) = f.second.block<1, 3>(0, 1).transpose();
  f.second.block<3, 3>(1, 1) = 1.5 / area * Matrix::Identity();
  add_composed(star, sums, positions, f, factor, sink);
}

// A r^2/12 with r = F.N/N.N
void add_perpendicular_squared_curvature_hessian(const VertexStar& star, std::span<const Vec3> positions,
                                                 double factor, HessianSink& sink) {
  const Star sums(star, positions);
  const double area = sums.sums[0];
  const Vector force = sums.sums.segment<3>(1);
  const Vector normal = sums.sums.segment<3>(4);
  const double square = normal.squaredNorm();
  if (!(square > 0)) return;
  const double ratio = force.dot(normal) / square;
  Eigen::Matrix<double, 6, 1> by;  // of the ratio, by F and N
  by << normal / square, (force - 2 * ratio * normal) / square;
  Eigen::Matrix<double, 6, 6> bend;
  bend.topLeftCorner<3, 3>().setZero();
  bend.topRightCorner<3, 3>() =
      Matrix::Identity() / square - 2 * normal * normal.transpose() / (square * square);
  bend.bottomLeftCorner<3, 3>() = bend.topRightCorner<3, 3>().transpose();
  const Vector by_normal = by.tail<3>();
  bend.bottomRightCorner<3, 3>() =
      -2 / square *
      (normal * by_normal.transpose() + by_normal * normal.transpose() + ratio * Matrix::Identity());
  Function f;
  f.first[0] = ratio * ratio / 12;
  f.first.tail<6>() = area * ratio / 6 * by;
  f.second.block<1, 6>(0, 1) = ratio / 6 * by.transpose();
  f.second.block<6, 1>(1, 0) = ratio / 6 * by;
  f.second.block<6, 6>(1, 1) = area / 6 * (by * by.transpose() + ratio * bend);
  add_composed(star, sums, positions, f, factor, sink);
}

}  // namespace lamella::energy
