// Rows by the numbers of elements, dense and sparse.
#include "datafile/id_table.h"

#include <gtest/gtest.h>

namespace lamella::datafile {

namespace {

using Duplicates = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

TEST(IdTable, FindsRows) {
  for (const std::uint32_t step : {1U, 100000000U}) {
    const std::vector<std::uint32_t> ids{3 * step, step, 20 * step, 2 * step};
    const IdTable table(ids);
    for (std::uint32_t row = 0; row < ids.size(); ++row) EXPECT_EQ(table.row(ids[row]), row);
    for (const std::uint32_t unknown : {0U, 4 * step, 21 * step, 4000000000U}) {
      EXPECT_EQ(table.row(unknown), IdTable::none) << unknown;
    }
    EXPECT_EQ(table.duplicates(), Duplicates{});
  }
}

TEST(IdTable, KeepsTheFirstOfTwo) {
  for (const std::uint32_t step : {1U, 100000000U}) {
    const std::vector<std::uint32_t> ids{2 * step, step, 2 * step, 2 * step};
    const IdTable table(ids);
    EXPECT_EQ(table.row(2 * step), 0U);
    EXPECT_EQ(table.duplicates(), (Duplicates{{2, 0}, {3, 0}}));
  }
}

TEST(IdTable, MayBeEmpty) {
  EXPECT_EQ(IdTable({}).row(1), IdTable::none);
}

}  // namespace

}  // namespace lamella::datafile
