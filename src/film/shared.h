// Values that copies share until one of them is changed.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

namespace lamella::film {

// A number that no other call in this process gets.
inline std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// Copying costs a pointer; `edit` makes the value this holder's own first, and gives it a new revision. Two
// holders with the same revision hold the same value, so results can be cached by revision, also across
// undo. References from `edit` must not be kept across a copy of the holder.
template <class T>
class Shared {
 public:
  Shared() : value_(std::make_shared<T>()) {}
  explicit Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  std::uint64_t revision() const { return revision_; }

  T& edit() {
    if (value_.use_count() != 1) value_ = std::make_shared<T>(*value_);
    revision_ = next_revision();
    return *value_;
  }

 private:
  std::shared_ptr<T> value_;
  std::uint64_t revision_ = next_revision();
};

}  // namespace lamella::film
