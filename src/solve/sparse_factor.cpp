#include "solve/sparse_factor.h"

#include <cstring>
#include <utility>

#include <cholmod.h>

#include "solve/dissection.h"

namespace lamella::solve {

struct SparseFactor::Work {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;  // kept between solves, as are the two below
  cholmod_dense* work_y = nullptr;
  cholmod_dense* work_e = nullptr;

  Work() {
    cholmod_start(&common);
    // For surfaces, minimum degree without supernodes gives the fastest solves, and solves are what repeats.
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
  }
  ~Work() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
};

namespace {

constexpr int large = 3000;  // rows above which dissection pays

// A view of the matrix; CHOLMOD reads it only.
cholmod_sparse as_cholmod(const LowerMatrix& matrix) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(matrix.size());
  a.nzmax = matrix.row.size();
  a.p = const_cast<int*>(matrix.column_start.data());
  a.i = const_cast<int*>(matrix.row.data());
  a.x = const_cast<double*>(matrix.value.data());
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = 0;
  a.packed = 1;
  return a;
}

}  // namespace

// Minimum degree is found at once but leaves more work than dissection on large films; dissection by places
// is found almost as fast.
SparseFactor::SparseFactor(const LowerMatrix& pattern, std::span<const film::Vec3> places)
    : work_(std::make_unique<Work>()) {
  cholmod_sparse a = as_cholmod(pattern);
  cholmod_common& common = work_->common;
  std::vector<int> order;
  if (!places.empty() && pattern.size() > large) {
    order.resize(static_cast<std::size_t>(pattern.size()));
    std::vector<int> pieces = dissection(pattern, places);
    common.method[0].ordering = CHOLMOD_GIVEN;
    if (cholmod_camd(&a, nullptr, 0, pieces.data(), order.data(), &common) == 0) order.clear();
  }
  if (order.empty()) common.method[0].ordering = CHOLMOD_AMD;
  work_->factor = cholmod_analyze_p(&a, order.empty() ? nullptr : order.data(), nullptr, 0, &common);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

bool SparseFactor::factorise(const LowerMatrix& matrix) {
  cholmod_sparse a = as_cholmod(matrix);
  if (work_->factor == nullptr || cholmod_factorize(&a, work_->factor, &work_->common) == 0) return false;
  return work_->common.status == CHOLMOD_OK && work_->factor->minor == work_->factor->n;
}

// In a simplicial L D L^T factor each column begins with its entry of D.
int SparseFactor::negative_pivots() const {
  const cholmod_factor& f = *work_->factor;
  const int* start = static_cast<const int*>(f.p);
  const double* value = static_cast<const double*>(f.x);
  int negative = 0;
  for (std::size_t j = 0; j < f.n; ++j) negative += value[start[j]] < 0 ? 1 : 0;
  return negative;
}

void SparseFactor::solve(std::span<double> values, int columns) {
  if (values.empty()) return;
  cholmod_dense b{};
  b.nrow = values.size() / static_cast<std::size_t>(columns);
  b.ncol = static_cast<std::size_t>(columns);
  b.nzmax = values.size();
  b.d = b.nrow;
  b.x = values.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  Work& w = *work_;
  cholmod_solve2(CHOLMOD_A, w.factor, &b, nullptr, &w.solution, nullptr, &w.work_y, &w.work_e, &w.common);
  std::memcpy(values.data(), w.solution->x, values.size() * sizeof(double));
}

}  // namespace lamella::solve
