// Memory for arrays that are swept over.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace lamella::film {

// Large arrays come in pages of 2 MB where the system has them: at 4 kB a page, a sweep over a large film
// spends much of its time on looking pages up, and what is fetched ahead of it ends with each page.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class Other>
  explicit(false) LargePages(const LargePages<Other>&) {}

  T* allocate(std::size_t count) {
    if (!is_large(count)) return static_cast<T*>(::operator new(count * sizeof(T), alignment));
    const std::size_t bytes = (count * sizeof(T) + page - 1) / page * page;
    void* const memory = std::aligned_alloc(page, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    madvise(memory, bytes, MADV_HUGEPAGE);  // where it is refused nothing is lost
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (is_large(count))
      std::free(memory);
    else
      ::operator delete(memory, alignment);
  }

  friend bool operator==(const LargePages&, const LargePages&) {
    return true;
  }

 private:
  static constexpr std::size_t page = std::size_t{1} << 21;
  static constexpr std::align_val_t alignment{64};
  static bool is_large(std::size_t count) {
    return count * sizeof(T) >= page;
  }
};

}  // namespace lamella::film
