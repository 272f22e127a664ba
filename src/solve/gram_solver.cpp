#include "solve/gram_solver.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

namespace lamella::solve {

namespace {

constexpr int most_dense_rows = 40;

using Map = Eigen::Map<const Eigen::VectorXd>;

Map vector_of(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

struct GramSolver::Work {
  std::vector<energy::GramEntry> pattern;
  int rows = 0;
  Eigen::MatrixXd dense;
  Eigen::LDLT<Eigen::MatrixXd> dense_factor;
  Eigen::SparseMatrix<double> sparse;  // lower triangle
  std::vector<double*> place;          // of each pattern entry in `sparse`
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> sparse_factor;

  bool is_dense() const { return rows <= most_dense_rows; }
};

GramSolver::GramSolver(int rows, const std::vector<energy::GramEntry>& pattern)
    : work_(std::make_unique<Work>()) {
  work_->rows = rows;
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
  work_->sparse_factor.analyzePattern(work_->sparse);
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
    *w.place[i] = idle ? 1.0 : values[i];
  }
  w.sparse_factor.factorize(w.sparse);
  if (w.sparse_factor.info() != Eigen::Success) return false;
  const Eigen::VectorXd d = w.sparse_factor.vectorD();
  return d.allFinite() && d.minCoeff() > 1e-14 * d.maxCoeff();
}

void GramSolver::solve(std::span<const double> right, std::span<double> multipliers) const {
  const Work& w = *work_;
  if (w.rows == 0) return;
  Eigen::Map<Eigen::VectorXd> result(multipliers.data(), static_cast<Eigen::Index>(multipliers.size()));
  if (w.is_dense()) {
    result = w.dense_factor.solve(vector_of(right));
  } else {
    result = w.sparse_factor.solve(vector_of(right));
  }
}

}  // namespace lamella::solve
