#include "solve/gram_solver.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <array>
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

// A symmetric matrix for products alone. Rows stand in bands of eight, a column of each after the other, so
// that eight sums go on side by side; rows that are shorter than the longest of their band end in zeros.
class BandedRows {
 public:
  BandedRows() = default;
  BandedRows(int rows, const std::vector<energy::GramEntry>& pattern) : rows_(rows) {
    std::vector<std::size_t> length(padded(), 0);
    for_each(pattern, [&](std::size_t, std::size_t row, std::size_t) { ++length[row]; });
    first_.push_back(0);
    for (std::size_t band = 0; band < padded() / width; ++band) {
      const auto begin = length.begin() + static_cast<std::ptrdiff_t>(band * width);
      first_.push_back(first_.back() + width * *std::max_element(begin, begin + width));
    }
    values_.assign(first_.back(), 0.0);
    columns_.assign(first_.back(), 0);
    places_.resize(pattern.size());
    std::fill(length.begin(), length.end(), 0);
    for_each(pattern, [&](std::size_t entry, std::size_t row, std::size_t column) {
      const std::size_t place = first_[row / width] + width * length[row]++ + row % width;
      columns_[place] = static_cast<std::uint32_t>(column);
      places_[entry][row < column ? 1 : 0] = place;
    });
  }

  void set(std::size_t entry, double value) {
    values_[places_[entry][0]] = value;
    if (places_[entry][1] != 0) values_[places_[entry][1]] = value;
  }
  void multiply(const Eigen::VectorXd& vector, Eigen::VectorXd& result) const {
    for (std::size_t band = 0; band + 1 < first_.size(); ++band) {
      std::array<double, width> sums{};
      for (std::size_t i = first_[band]; i < first_[band + 1]; i += width) {
        for (std::size_t row = 0; row < width; ++row)
          sums[row] += values_[i + row] * vector[columns_[i + row]];
      }
      const std::size_t end = std::min(width, static_cast<std::size_t>(rows_) - band * width);
      for (std::size_t row = 0; row < end; ++row)
        result[static_cast<Eigen::Index>(band * width + row)] = sums[row];
    }
  }

 private:
  static constexpr std::size_t width = 8;
  std::size_t padded() const { return (static_cast<std::size_t>(rows_) + width - 1) / width * width; }
  // Calls function(entry, row, column) for both triangles.
  template <class Function>
  static void for_each(const std::vector<energy::GramEntry>& pattern, const Function& function) {
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      const auto row = static_cast<std::size_t>(pattern[i].row);
      const auto column = static_cast<std::size_t>(pattern[i].column);
      function(i, row, column);
      if (row != column) function(i, column, row);
    }
  }

  int rows_ = 0;
  std::vector<std::size_t> first_;  // of each band
  std::vector<double> values_;
  std::vector<std::uint32_t> columns_;
  std::vector<std::array<std::size_t, 2>> places_;  // of each pattern entry; no second one on the diagonal
};

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

  // For iterations.
  BandedRows whole;
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
  if (work_->iterates) {
    work_->whole = BandedRows(rows, pattern);
    work_->inverse_diagonal.resize(rows);
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
    const energy::GramEntry entry = w.pattern[i];
    const bool diagonal = entry.row == entry.column;
    const double value = diagonal && values[i] == 0 ? 1.0 : values[i];
    if (!w.iterates) {
      *w.place[i] = value;
      continue;
    }
    w.whole.set(i, value);
    if (diagonal) w.inverse_diagonal[entry.row] = 1 / value;
  }
  if (w.iterates) return w.inverse_diagonal.allFinite() && w.inverse_diagonal.minCoeff() > 0;
  w.sparse_factor.factorize(w.sparse);
  if (w.sparse_factor.info() != Eigen::Success) return false;
  const Eigen::VectorXd d = w.sparse_factor.vectorD();
  return d.allFinite() && d.minCoeff() > 1e-14 * d.maxCoeff();
}

namespace {

// Conjugate gradients preconditioned by the diagonal, from 0: callers give what is left after a good guess.
Eigen::VectorXd iterate(const BandedRows& matrix, const Eigen::VectorXd& inverse_diagonal,
                        Eigen::VectorXd residual, double left) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(residual.size());
  Eigen::VectorXd scaled = inverse_diagonal.cwiseProduct(residual);
  Eigen::VectorXd direction = scaled;
  Eigen::VectorXd image(residual.size());
  double product = residual.dot(scaled);
  const double enough = iterated_to * iterated_to * product;
  for (Eigen::Index i = 0; i < residual.size() && product > 0; ++i) {
    if (left > 0 ? residual.lpNorm<Eigen::Infinity>() <= left : product <= enough) break;
    matrix.multiply(direction, image);
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
