#include "solve/frontal_factor.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace lamella::solve {

namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Index = Eigen::Index;

constexpr Index block = 48;            // columns eliminated at a time
constexpr double worth_threads = 1e8;  // multiplications, from which on it pays to share them out
constexpr double branches = 16;        // that threads are given, or somewhat more
// Large updates are made in strips of so many columns, side by side.
constexpr Index strip = 96;
constexpr Index worth_strips = 4 * strip;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

Index index(std::size_t i) {
  return static_cast<Index>(i);
}

// L D L^T of a small matrix, in place: D on the diagonal. False if a pivot vanishes.
bool eliminate(Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>> a) {
  const Index n = a.rows();
  for (Index j = 0; j < n; ++j) {
    const double pivot = a(j, j);
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot)) return false;
    for (Index k = j + 1; k < n; ++k) {
      const double factor = a(k, j) / pivot;
      for (Index i = k; i < n; ++i) a(i, k) -= factor * a(i, j);
    }
    for (Index i = j + 1; i < n; ++i) a(i, j) /= pivot;
  }
  return true;
}

// The lower half of an update loses left * right^T.
template <class Left, class Right>
void take(Matrix& update, const Left& left, const Right& right) {
  const Index rest = update.rows();
  if (rest < worth_strips) {
    update.triangularView<Eigen::Lower>() -= left * right.transpose();
    return;
  }
#pragma omp taskloop grainsize(1) shared(update, left, right)
  for (Index s = 0; s < (rest + strip - 1) / strip; ++s) {
    const Index first = s * strip;
    const Index width = std::min(strip, rest - first);
    update.block(first, first, width, width).template triangularView<Eigen::Lower>() -=
        left.middleRows(first, width) * right.middleRows(first, width).transpose();
    const Index below = rest - first - width;
    update.block(first + width, first, below, width).noalias() -=
        left.bottomRows(below) * right.middleRows(first, width).transpose();
  }
}

// Eliminates all columns of a panel; `update` loses what they take.
bool eliminate_panel(Matrix panel, Matrix update) {
  const Index rows = panel.rows();
  const Index own = panel.cols();
  Eigen::MatrixXd scaled;  // columns of L D
  for (Index first = 0; first < own; first += block) {
    const Index width = std::min(block, own - first);
    const Index last = first + width;
    auto corner = panel.block(first, first, width, width);
    if (!eliminate(corner)) return false;
    if (last == rows) break;
    auto below = panel.block(last, first, rows - last, width);
    corner.triangularView<Eigen::UnitLower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    scaled = below;
    for (Index j = 0; j < width; ++j) below.col(j) /= corner(j, j);
    // Tall strips: their upper halves are wasted, and little of the work.
    for (Index next = last; next < own; next += block) {
      const Index more = std::min(block, own - next);
      panel.block(next, next, rows - next, more).noalias() -=
          below.bottomRows(rows - next) * scaled.middleRows(next - last, more).transpose();
    }
    if (rows > own) take(update, below.bottomRows(rows - own), scaled.bottomRows(rows - own));
  }
  return true;
}

}  // namespace

FrontalFactor::FrontalFactor(const LowerMatrix& pattern, const Dissection& pieces)
    : fronts_(pieces.parent.size()), order_(at(pattern.size())) {
  find_rows(pattern, pieces);
  find_entries(pattern, pieces);
}

void FrontalFactor::find_rows(const LowerMatrix& pattern, const Dissection& pieces) {
  for (std::size_t i = 0; i < order_.size(); ++i)
    fronts_[at(pieces.piece[i])].rows.push_back(static_cast<int>(i));
  int next = 0;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    front.parent = pieces.parent[f];
    front.own = static_cast<int>(front.rows.size());
    for (const int row : front.rows) order_[at(row)] = next++;
    if (front.parent >= 0) fronts_[at(front.parent)].children.push_back(static_cast<int>(f));
  }
  // Ties to rows of later pieces.
  for (std::size_t j = 0; j < order_.size(); ++j) {
    for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k) {
      const int i = pattern.row[at(k)];
      const int a = pieces.piece[at(i)];
      const int b = pieces.piece[j];
      if (a != b) fronts_[at(std::min(a, b))].rows.push_back(a < b ? static_cast<int>(j) : i);
    }
  }
  std::vector<int> seen(order_.size(), -1);
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    for (const int child : front.children) {
      const Front& below = fronts_[at(child)];
      front.work += below.work;
      front.rows.insert(front.rows.end(), below.rows.begin() + below.own, below.rows.end());
    }
    std::erase_if(front.rows, [&](int row) {
      return std::exchange(seen[at(row)], static_cast<int>(f)) == static_cast<int>(f);
    });
    std::sort(front.rows.begin() + front.own, front.rows.end(),
              [&](int a, int b) { return order_[at(a)] < order_[at(b)]; });
    front.work += static_cast<double>(front.own) * static_cast<double>(front.size() * front.size());
    front.panel = panel_size_;
    panel_size_ += front.size() * at(front.own);
    if (front.parent < 0) work_ += front.work;
  }
}

void FrontalFactor::find_entries(const LowerMatrix& pattern, const Dissection& pieces) {
  std::vector<std::vector<std::array<int, 2>>> columns(fronts_.size());  // an entry and its column
  for (std::size_t j = 0; j < order_.size(); ++j) {
    for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k) {
      const int piece = std::min(pieces.piece[at(pattern.row[at(k)])], pieces.piece[j]);
      columns[at(piece)].push_back({k, static_cast<int>(j)});
    }
  }
  std::vector<int> place(order_.size());
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Front& front = fronts_[f];
    for (std::size_t i = 0; i < front.size(); ++i) place[at(front.rows[i])] = static_cast<int>(i);
    for (const auto& [entry, column] : columns[f]) {
      const auto [low, high] = std::minmax(place[at(pattern.row[at(entry)])], place[at(column)]);
      front.entries.push_back({entry, high, low});
    }
    for (const int c : front.children) {
      Front& child = fronts_[at(c)];
      for (std::size_t i = at(child.own); i < child.size(); ++i)
        child.in_parent.push_back(place[at(child.rows[i])]);
    }
  }
}

// A front has its own rows in its first columns; the rest goes to the update.
void FrontalFactor::assemble(Front& front, const LowerMatrix& matrix) {
  const std::size_t size = front.size();
  const std::size_t own = at(front.own);
  const std::size_t rest = front.rest();
  double* const own_columns = panel(front);
  std::fill_n(own_columns, size * own, 0.0);
  spare_.take(front.update, rest * rest);
  for (const auto& [entry, row, column] : front.entries)
    own_columns[at(column) * size + at(row)] += matrix.value[at(entry)];
  for (const int c : front.children) {
    Front& child = fronts_[at(c)];
    const std::size_t count = child.rest();
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t column = at(child.in_parent[j]);
      const double* const from = child.update.data() + j * count;
      double* const to = column < own ? own_columns + column * size : front.update.data();
      const std::size_t skip = column < own ? 0 : own - (column - own) * rest;  // modulo the word
      for (std::size_t i = j; i < count; ++i) to[at(child.in_parent[i]) - skip] += from[i];
    }
    front.sound = front.sound && child.sound;
    spare_.give(child.update);
  }
}

// All below a front, and the front.
void FrontalFactor::climb(int f, const LowerMatrix& matrix) {
  for (const int child : fronts_[at(f)].children) climb(child, matrix);
  eliminate_front(fronts_[at(f)], matrix);
}

void FrontalFactor::eliminate_front(Front& front, const LowerMatrix& matrix) {
  front.sound = true;
  assemble(front, matrix);
  const Index size = index(front.size());
  const Index rest = index(front.rest());
  front.sound =
      front.sound && eliminate_panel(Matrix(panel(front), size, front.own, Eigen::OuterStride<>(size)),
                                     Matrix(front.update.data(), rest, rest, Eigen::OuterStride<>(rest)));
}

// Branches that are small enough go side by side, and the trunk that is left after them in their order: its
// fronts are few and large, and shared out by themselves.
bool FrontalFactor::factorise(const LowerMatrix& matrix) {
  if (panels_.data() == nullptr) panels_ = LargeArray(panel_size_);
  const double most = work_ / branches;
  const auto in_trunk = [&](const Front& front) { return front.work > most; };
#pragma omp parallel if (work_ > worth_threads)
#pragma omp single
  {
    for (std::size_t f = fronts_.size(); f-- > 0;) {
      const Front& front = fronts_[f];
      if (in_trunk(front) || (front.parent >= 0 && !in_trunk(fronts_[at(front.parent)]))) continue;
#pragma omp task firstprivate(f) shared(matrix)
      climb(static_cast<int>(f), matrix);
    }
#pragma omp taskwait
    for (Front& front : fronts_) {
      if (in_trunk(front)) eliminate_front(front, matrix);
    }
  }
  return std::all_of(fronts_.begin(), fronts_.end(), [](const Front& front) { return front.sound; });
}

int FrontalFactor::negative_pivots() const {
  int negative = 0;
  for (const Front& front : fronts_) {
    for (std::size_t j = 0; j < at(front.own); ++j)
      negative += panel(front)[j * front.size() + j] < 0 ? 1 : 0;
  }
  return negative;
}

void FrontalFactor::solve(std::span<double> values, int columns) {
  const std::size_t n = order_.size();
  Eigen::MatrixXd part;
  const auto gather = [&](const Front& front) {
    part.resize(index(front.size()), columns);
    for (int c = 0; c < columns; ++c) {
      for (std::size_t i = 0; i < front.size(); ++i)
        part(index(i), c) = values[at(c) * n + at(front.rows[i])];
    }
  };
  const auto scatter = [&](const Front& front, std::size_t count) {
    for (int c = 0; c < columns; ++c) {
      for (std::size_t i = 0; i < count; ++i) values[at(c) * n + at(front.rows[i])] = part(index(i), c);
    }
  };
  for (Front& front : fronts_) {
    const Index size = index(front.size());
    const Matrix columns_of_l(panel(front), size, front.own, Eigen::OuterStride<>(size));
    gather(front);
    auto own = part.topRows(front.own);
    columns_of_l.topRows(front.own).triangularView<Eigen::UnitLower>().solveInPlace(own);
    part.bottomRows(index(front.rest())).noalias() -= columns_of_l.bottomRows(index(front.rest())) * own;
    for (Index j = 0; j < front.own; ++j) own.row(j) /= columns_of_l(j, j);
    scatter(front, front.size());
  }
  for (std::size_t f = fronts_.size(); f-- > 0;) {
    Front& front = fronts_[f];
    const Index size = index(front.size());
    const Matrix columns_of_l(panel(front), size, front.own, Eigen::OuterStride<>(size));
    gather(front);
    auto own = part.topRows(front.own);
    own.noalias() -=
        columns_of_l.bottomRows(index(front.rest())).transpose() * part.bottomRows(index(front.rest()));
    columns_of_l.topRows(front.own).triangularView<Eigen::UnitLower>().transpose().solveInPlace(own);
    scatter(front, at(front.own));
  }
}

}  // namespace lamella::solve
