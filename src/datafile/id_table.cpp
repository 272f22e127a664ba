#include "datafile/id_table.h"

#include <algorithm>

namespace lamella::datafile {

IdTable::IdTable(std::span<const std::uint32_t> ids) {
  std::uint32_t largest = 0;
  for (const std::uint32_t id : ids) largest = std::max(largest, id);
  // A table with a few times as many places as there are elements beats a search.
  if (largest <= 4 * ids.size() + 1024) {
    fill_dense(ids, largest);
  } else {
    fill_sparse(ids);
  }
}

void IdTable::fill_dense(std::span<const std::uint32_t> ids, std::uint32_t largest) {
  dense_.assign(std::size_t{largest} + 1, none);
  for (std::uint32_t row = 0; row < ids.size(); ++row) {
    std::uint32_t& place = dense_[ids[row]];
    if (place == none) {
      place = row;
    } else {
      duplicates_.emplace_back(row, place);
    }
  }
}

void IdTable::fill_sparse(std::span<const std::uint32_t> ids) {
  sparse_.reserve(ids.size());
  for (std::uint32_t row = 0; row < ids.size(); ++row) sparse_.emplace_back(ids[row], row);
  std::sort(sparse_.begin(), sparse_.end());
  for (std::size_t i = 1; i < sparse_.size(); ++i) {
    if (sparse_[i].first != sparse_[i - 1].first) continue;
    const std::uint32_t first = row(sparse_[i].first);
    duplicates_.emplace_back(sparse_[i].second, first);
  }
}

std::uint32_t IdTable::row(std::uint32_t id) const {
  if (!dense_.empty()) return id < dense_.size() ? dense_[id] : none;
  const auto at = std::lower_bound(sparse_.begin(), sparse_.end(), std::pair(id, 0U));
  return at != sparse_.end() && at->first == id ? at->second : none;
}

}  // namespace lamella::datafile
