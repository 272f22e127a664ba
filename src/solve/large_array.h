// Numbers without first values.
#pragma once

#include <cstddef>
#include <memory>

#include "film/large_pages.h"

namespace lamella::solve {

// For factors of hundreds of megabytes: a vector would write zeros that are overwritten at once.
class LargeArray {
 public:
  LargeArray() = default;
  explicit LargeArray(std::size_t size) : data_(size > 0 ? Pages().allocate(size) : nullptr, Free(size)) {}

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }

 private:
  using Pages = film::LargePages<double>;
  struct Free {
    Free() : size(0) {}
    explicit Free(std::size_t count) : size(count) {}
    std::size_t size;
    void operator()(double* p) const { Pages().deallocate(p, size); }
  };
  std::unique_ptr<double, Free> data_;
};

}  // namespace lamella::solve
