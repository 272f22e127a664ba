// Numbers for which the system's largest pages are asked.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace lamella::solve {

// An array without first values. Memory that a program touches for the first time comes page by page, and for
// hundreds of megabytes that costs as much as the arithmetic on them; pages of two megabytes are fewer.
class LargeArray {
 public:
  LargeArray() = default;
  explicit LargeArray(std::size_t size) {
    if (size == 0) return;
    const std::size_t bytes = (size * sizeof(double) + page - 1) / page * page;
    data_.reset(static_cast<double*>(std::aligned_alloc(page, bytes)));
    if (data_ == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    madvise(data_.get(), bytes, MADV_HUGEPAGE);  // where it is refused nothing is lost
#endif
  }

  double* data() {
    return data_.get();
  }
  const double* data() const {
    return data_.get();
  }

 private:
  static constexpr std::size_t page = std::size_t{1} << 21;
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double, Free> data_;
};

}  // namespace lamella::solve
