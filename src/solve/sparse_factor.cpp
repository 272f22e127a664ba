#include "solve/sparse_factor.h"

#include <cstring>
#include <utility>

#include <cholmod.h>

#include "solve/frontal_factor.h"

namespace lamella::solve {

struct SparseFactor::Work {
  cholmod_common common{};
  std::shared_ptr<FrontalFactor> fronts;  // or else the rest
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
    if (fronts) fronts->forget_values();
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

constexpr int large = 2000;       // rows above which fronts pay
constexpr std::size_t leaf = 32;  // rows of the smallest fronts

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

// Minimum degree and scalar columns are fastest for small matrices, dissection and dense fronts for large
// ones.
SparseFactor::SparseFactor(const LowerMatrix& pattern, std::span<const film::Vec3> places,
                           SymbolicMemory* memory)
    : work_(std::make_unique<Work>()) {
  if (!places.empty() && pattern.size() > large) {
    if (memory != nullptr && memory->fronts_.use_count() == 1 && memory->row_ == pattern.row &&
        memory->column_start_ == pattern.column_start) {
      work_->fronts = memory->fronts_;
      return;
    }
    work_->fronts = std::make_shared<FrontalFactor>(pattern, dissection(pattern, places, leaf));
    if (memory != nullptr) {
      memory->column_start_ = pattern.column_start;
      memory->row_ = pattern.row;
      memory->fronts_ = work_->fronts;
    }
    return;
  }
  cholmod_sparse a = as_cholmod(pattern);
  work_->factor = cholmod_analyze(&a, &work_->common);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

bool SparseFactor::factorise(const LowerMatrix& matrix) {
  if (work_->fronts) return work_->fronts->factorise(matrix);
  cholmod_sparse a = as_cholmod(matrix);
  if (work_->factor == nullptr || cholmod_factorize(&a, work_->factor, &work_->common) == 0) return false;
  return work_->common.status == CHOLMOD_OK && work_->factor->minor == work_->factor->n;
}

// In a simplicial L D L^T factor each column begins with its entry of D.
int SparseFactor::negative_pivots() const {
  if (work_->fronts) return work_->fronts->negative_pivots();
  const cholmod_factor& f = *work_->factor;
  const int* start = static_cast<const int*>(f.p);
  const double* value = static_cast<const double*>(f.x);
  int negative = 0;
  for (std::size_t j = 0; j < f.n; ++j) negative += value[start[j]] < 0 ? 1 : 0;
  return negative;
}

void SparseFactor::solve(std::span<double> values, int columns) {
  if (values.empty()) return;
  if (work_->fronts) return work_->fronts->solve(values, columns);
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
