// From the number of an element in a datafile to its row.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lamella::datafile {

// Numbers may have gaps and stand in any order, up to 2^31.
class IdTable {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  // Of a number that occurs twice, the first row counts.
  explicit IdTable(std::span<const std::uint32_t> ids);

  // The row with a number, or `none`.
  std::uint32_t row(std::uint32_t id) const;
  // Rows with a number that an earlier row has, each with that earlier row.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& duplicates() const { return duplicates_; }

 private:
  void fill_dense(std::span<const std::uint32_t> ids, std::uint32_t largest);
  void fill_sparse(std::span<const std::uint32_t> ids);

  std::vector<std::uint32_t> dense_;                             // row by number
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sparse_;  // number and row, sorted
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates_;
};

}  // namespace lamella::datafile
