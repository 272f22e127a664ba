#include "solve/modes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

namespace lamella::solve {

namespace {

constexpr Eigen::Index block = 4;
constexpr double accuracy = 1e-9;    // of the inverse's eigenvalues
constexpr double dependent = 1e-10;  // what is left of a vector that the others span
constexpr int most_shifts = 30;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

class Lanczos {
 public:
  Lanczos(NewtonSystem& system, int count)
      : system_(system),
        mass_(Eigen::Map<const Vector>(system.hessian().mass().data(),
                                       static_cast<Eigen::Index>(system.hessian().unknowns()))),
        wanted_(std::min<Eigen::Index>(count, freedoms())) {}

  std::vector<Mode> run(scene::Monitor& monitor);

 private:
  Eigen::Index freedoms() const { return static_cast<Eigen::Index>(system_.mode_count()); }
  bool find_shift();
  Matrix random_block();
  Matrix apply(const Matrix& v);
  Matrix orthonormal(Matrix w, Matrix& remainder) const;
  void grow(const Matrix& next);
  bool converged(const Matrix& remainder, const Eigen::SelfAdjointEigenSolver<Matrix>& ritz) const;
  std::vector<Mode> modes(const Eigen::SelfAdjointEigenSolver<Matrix>& ritz);

  NewtonSystem& system_;
  Eigen::Map<const Vector> mass_;
  Eigen::Index wanted_;
  std::mt19937 random_{1};
  double shift_ = 0;
  Matrix basis_;      // columns orthonormal in the mass
  Matrix projected_;  // the operator in that basis
};

// A shift that lifts every mode above zero: then the lowest modes are the largest of the inverse.
bool Lanczos::find_shift() {
  shift_ = system_.scale();
  for (int i = 0; i < most_shifts; ++i, shift_ *= 4) {
    if (system_.factorise(shift_) && system_.negative_modes() == 0) return true;
  }
  return false;
}

// (H + shift M)^-1 M v among the motions that keep volumes.
Matrix Lanczos::apply(const Matrix& v) {
  const auto rows = v.rows() + static_cast<Eigen::Index>(system_.hessian().constraints());
  Matrix right = Matrix::Zero(rows, v.cols());
  right.topRows(v.rows()) = mass_.asDiagonal() * v;
  system_.solve({right.data(), static_cast<std::size_t>(right.size())}, static_cast<int>(v.cols()));
  return right.topRows(v.rows());
}

// What of w the basis does not span, orthonormal: columns that nothing is left of are dropped. `remainder`
// gets the coefficients, w = basis (...) + result remainder.
Matrix Lanczos::orthonormal(Matrix w, Matrix& remainder) const {
  const Vector before = (w.transpose() * mass_.asDiagonal() * w).diagonal().cwiseSqrt();
  for (int pass = 0; pass < 2; ++pass) w -= basis_ * (basis_.transpose() * (mass_.asDiagonal() * w));
  Matrix result(w.rows(), w.cols());
  remainder = Matrix::Zero(w.cols(), w.cols());
  Eigen::Index kept = 0;
  for (Eigen::Index j = 0; j < w.cols(); ++j) {
    Vector column = w.col(j);
    for (int pass = 0; pass < 2; ++pass) {
      const Vector part = result.leftCols(kept).transpose() * (mass_.asDiagonal() * column);
      column -= result.leftCols(kept) * part;
      remainder.col(j).head(kept) += part;
    }
    const double size = std::sqrt(column.dot(mass_.asDiagonal() * column));
    if (!(size > dependent * before[j])) continue;
    remainder(kept, j) = size;
    result.col(kept++) = column / size;
  }
  remainder.conservativeResize(kept, w.cols());
  return result.leftCols(kept);
}

Matrix Lanczos::random_block() {
  std::normal_distribution<double> normal;
  return Matrix::NullaryExpr(mass_.size(), block,
                             [&](Eigen::Index, Eigen::Index) { return normal(random_); });
}

void Lanczos::grow(const Matrix& next) {
  basis_.conservativeResize(mass_.size(), basis_.cols() + next.cols());
  basis_.rightCols(next.cols()) = next;
}

// The residual of a Ritz pair is the part of the next block that its last entries reach.
bool Lanczos::converged(const Matrix& remainder, const Eigen::SelfAdjointEigenSolver<Matrix>& ritz) const {
  const Eigen::Index size = projected_.rows();
  if (size < wanted_) return false;
  const Eigen::Index last = std::min<Eigen::Index>(remainder.cols(), size);
  for (Eigen::Index k = 0; k < wanted_; ++k) {
    const Vector tail = ritz.eigenvectors().col(size - 1 - k).tail(last);
    if ((remainder * tail).norm() > accuracy * std::abs(ritz.eigenvalues()[size - 1 - k])) return false;
  }
  return true;
}

std::vector<Mode> Lanczos::modes(const Eigen::SelfAdjointEigenSolver<Matrix>& ritz) {
  std::vector<Mode> result;
  const Eigen::Index size = projected_.rows();
  for (Eigen::Index k = 0; k < std::min(wanted_, size); ++k) {
    Mode mode;
    mode.value = 1 / ritz.eigenvalues()[size - 1 - k] - shift_;
    const Vector x = basis_.leftCols(size) * ritz.eigenvectors().col(size - 1 - k);
    mode.reduced.assign(x.data(), x.data() + x.size());
    for (const std::vector<double>& rigid : system_.rigid()) {
      const double part = Eigen::Map<const Vector>(rigid.data(), x.size()).dot(mass_.asDiagonal() * x);
      mode.rigid_part += part * part;
    }
    result.push_back(std::move(mode));
  }
  return result;
}

std::vector<Mode> Lanczos::run(scene::Monitor& monitor) {
  if (wanted_ == 0 || !find_shift()) return {};
  Matrix remainder;
  basis_.resize(mass_.size(), 0);
  grow(orthonormal(apply(random_block()), remainder));
  while (true) {
    const Eigen::Index first = projected_.rows();
    const Matrix image = apply(basis_.rightCols(basis_.cols() - first));
    const Matrix part = basis_.transpose() * (mass_.asDiagonal() * image);
    projected_.conservativeResize(basis_.cols(), basis_.cols());
    projected_.rightCols(part.cols()) = part;
    projected_.bottomRows(part.cols()) = part.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix> ritz(projected_);
    Matrix next = orthonormal(image, remainder);
    if (converged(remainder, ritz)) return modes(ritz);
    // A space that the operator does not leave may lack modes of high multiplicity: go on elsewhere.
    if (next.cols() == 0) next = orthonormal(apply(random_block()), remainder);
    if (next.cols() == 0) return modes(ritz);
    monitor.progress(static_cast<long>(basis_.cols()), 0, 1 / ritz.eigenvalues().maxCoeff() - shift_);
    if (monitor.stop_requested()) return {};
    grow(next);
  }
}

}  // namespace

std::vector<Mode> lowest_modes(NewtonSystem& system, int count, scene::Monitor& monitor) {
  return Lanczos(system, count).run(monitor);
}

}  // namespace lamella::solve
