// Arrays that are given back for the next one who needs one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <vector>

namespace lamella::solve {

// Memory that goes back to the system comes anew page by page, cleared: for large arrays that come and go
// that costs as much as what is done with them. Threads may share one.
class SpareArrays {
 public:
  // `array`, empty so far, becomes so many zeros.
  void take(std::vector<double>& array, std::size_t size) {
    if (size >= worth_keeping) {
      const std::lock_guard lock(mutex_);
      // The smallest that is large enough, or else the largest, which grows.
      const auto at =
          std::find_if(spare_.begin(), spare_.end(), [&](const auto& a) { return a.capacity() >= size; });
      if (!spare_.empty()) {
        const auto best = at == spare_.end() ? at - 1 : at;
        array = std::move(*best);
        spare_.erase(best);
      }
    }
    array.assign(size, 0.0);
  }
  // Leaves it empty.
  void give(std::vector<double>& array) {
    if (array.capacity() >= worth_keeping) {
      const std::lock_guard lock(mutex_);
      const auto at = std::find_if(spare_.begin(), spare_.end(),
                                   [&](const auto& a) { return a.capacity() >= array.capacity(); });
      spare_.insert(at, std::move(array));
    }
    array = {};
  }
  void clear() { spare_ = {}; }

 private:
  static constexpr std::size_t worth_keeping = 1 << 15;
  std::mutex mutex_;
  std::vector<std::vector<double>> spare_;  // by size
};

}  // namespace lamella::solve
