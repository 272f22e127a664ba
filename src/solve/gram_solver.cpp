#include "solve/gram_solver.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

namespace lamella::solve {

namespace {

constexpr int most_dense_rows = 40;
// Cells that share only a vertex couple too, so that factors fill: beyond this they cost more than
// iterations.
constexpr int most_factorised_rows = 200;
constexpr double iterated_to = 1e-9;

using Map = Eigen::Map<const Eigen::VectorXd>;

Map vector_of(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

struct GramSolver::Work {
  std::vector<energy::GramEntry> pattern;
  int rows = 0;
  bool iterates = false;
  Eigen::MatrixXd dense;
  Eigen::LDLT<Eigen::MatrixXd> dense_factor;
  Eigen::SparseMatrix<double> sparse;  // lower triangle
  std::vector<double*> place;          // of each pattern entry in `sparse`
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> sparse_factor;

  // For iterations: both triangles, so that a row's product is one sum.
  Eigen::SparseMatrix<double, Eigen::RowMajor> whole;
  std::vector<std::array<double*, 2>> place_in_whole;
  Eigen::VectorXd inverse_diagonal;

  bool is_dense() const { return rows <= most_dense_rows; }
};

GramSolver::GramSolver(int rows, const std::vector<energy::GramEntry>& pattern, Kind kind)
    : work_(std::make_unique<Work>()) {
  work_->rows = rows;
  work_->iterates = kind == Kind::fastest && rows > most_factorised_rows;
  work_->pattern = pattern;
  if (work_->is_dense()) {
    work_->dense = Eigen::MatrixXd::Zero(rows, rows);
    return;
  }
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(pattern.size());
  for (const energy::GramEntry& entry : pattern) triplets.emplace_back(entry.row, entry.column, 1.0);
  work_->sparse.resize(rows, rows);
  work_->sparse.setFromTriplets(triplets.begin(), triplets.end());
  for (const energy::GramEntry& entry : pattern)
    work_->place.push_back(&work_->sparse.coeffRef(entry.row, entry.column));
  if (!work_->iterates) {
    work_->sparse_factor.analyzePattern(work_->sparse);
    return;
  }
  work_->whole = work_->sparse.selfadjointView<Eigen::Lower>();
  for (const energy::GramEntry& entry : pattern) {
    work_->place_in_whole.push_back(
        {&work_->whole.coeffRef(entry.row, entry.column), &work_->whole.coeffRef(entry.column, entry.row)});
  }
}

GramSolver::~GramSolver() = default;
GramSolver::GramSolver(GramSolver&&) noexcept = default;
GramSolver& GramSolver::operator=(GramSolver&&) noexcept = default;

bool GramSolver::factorise(std::span<const double> values) {
  Work& w = *work_;
  if (w.rows == 0) return true;
  // A body that nothing can move has a zero row. A 1 on the diagonal keeps the rest solvable; whatever
  // multiplier it gets then multiplies a zero gradient.
  if (w.is_dense()) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const energy::GramEntry entry = w.pattern[i];
      const bool idle = entry.row == entry.column && values[i] == 0;
      w.dense(entry.row, entry.column) = idle ? 1.0 : values[i];
      w.dense(entry.column, entry.row) = w.dense(entry.row, entry.column);
    }
    w.dense_factor.compute(w.dense);
    const Eigen::VectorXd d = w.dense_factor.vectorD();
    return d.allFinite() && d.minCoeff() > 1e-14 * d.maxCoeff();
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool idle = w.pattern[i].row == w.pattern[i].column && values[i] == 0;
    const double value = idle ? 1.0 : values[i];
    if (w.iterates) {
      *w.place_in_whole[i][0] = *w.place_in_whole[i][1] = value;
    } else {
      *w.place[i] = value;
    }
  }
  if (w.iterates) {
    w.inverse_diagonal = w.whole.diagonal().cwiseInverse();
    return w.inverse_diagonal.allFinite() && w.inverse_diagonal.minCoeff() > 0;
  }
  w.sparse_factor.factorize(w.sparse);
  if (w.sparse_factor.info() != Eigen::Success) return false;
  const Eigen::VectorXd d = w.sparse_factor.vectorD();
  return d.allFinite() && d.minCoeff() > 1e-14 * d.maxCoeff();
}

namespace {

// Conjugate gradients preconditioned by the diagonal, from 0: callers give what is left after a good guess.
Eigen::VectorXd iterate(const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix,
                        const Eigen::VectorXd& inverse_diagonal, Eigen::VectorXd residual, double left) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(residual.size());
  Eigen::VectorXd scaled = inverse_diagonal.cwiseProduct(residual);
  Eigen::VectorXd direction = scaled;
  Eigen::VectorXd image(residual.size());
  double product = residual.dot(scaled);
  const double enough = iterated_to * iterated_to * product;
  for (Eigen::Index i = 0; i < residual.size() && product > 0; ++i) {
    if (left > 0 ? residual.lpNorm<Eigen::Infinity>() <= left : product <= enough) break;
    image.noalias() = matrix * direction;
    const double length = product / direction.dot(image);
    result += length * direction;
    residual -= length * image;
    scaled = inverse_diagonal.cwiseProduct(residual);
    const double next = residual.dot(scaled);
    direction = scaled + (next / product) * direction;
    product = next;
  }
  return result;
}

}  // namespace

void GramSolver::solve(std::span<const double> right, std::span<double> multipliers, double enough) const {
  const Work& w = *work_;
  if (w.rows == 0) return;
  Eigen::Map<Eigen::VectorXd> result(multipliers.data(), static_cast<Eigen::Index>(multipliers.size()));
  if (w.is_dense()) {
    result = w.dense_factor.solve(vector_of(right));
  } else if (w.iterates) {
    result = iterate(w.whole, w.inverse_diagonal, vector_of(right), enough);
  } else {
    result = w.sparse_factor.solve(vector_of(right));
  }
}

}  // namespace lamella::solve
