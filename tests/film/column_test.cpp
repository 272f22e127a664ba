#include "film/column.h"

#include <gtest/gtest.h>

namespace lamella::film {
namespace {

TEST(Column, RowsGetTheBlankValueAndKeepTheirOwn) {
  Columns columns;
  columns.resize(2);
  columns.add(real_column("heat", 1.5, 2));
  columns.edit("heat")->set(1, 1, 7);
  columns.resize(4);
  const Column& heat = *columns.find("heat");
  EXPECT_EQ(heat.value(0, 0), 1.5);
  EXPECT_EQ(heat.value(1, 1), 7);
  EXPECT_EQ(heat.value(3, 0), 1.5);
  EXPECT_EQ(columns.reals("heat").size(), 8U);
  EXPECT_TRUE(columns.flags("heat").empty());
  EXPECT_EQ(columns.find("cold"), nullptr);
}

TEST(Column, IntegersRoundAndFlagsAreZeroOrOne) {
  Columns columns;
  columns.resize(1);
  columns.add(integer_column("colour", 15));
  columns.add(flag_column("fixed"));
  EXPECT_EQ(columns.find("colour")->value(0), 15);
  columns.edit("colour")->set(0, 0, 2.6);
  EXPECT_EQ(columns.find("colour")->value(0), 3);
  columns.edit("fixed")->set(0, 0, 42);
  EXPECT_EQ(columns.find("fixed")->value(0), 1);
}

TEST(Column, MeansCopiesAndRenumbering) {
  Columns columns;
  columns.resize(3);
  columns.add(real_column("v", 0, 2));
  Column& v = *columns.edit("v");
  v.set(0, 0, 1);
  v.set(0, 1, 10);
  v.set(1, 0, 3);
  v.set(1, 1, 30);
  v.set_mean(0, 1, 2);
  EXPECT_EQ(v.value(2, 0), 2);
  EXPECT_EQ(v.value(2, 1), 20);
  v.copy_row(1, 0);
  EXPECT_EQ(v.value(0, 1), 30);
  const std::vector<std::uint32_t> order{2, 0};
  v.renumber(order);
  EXPECT_EQ(v.value(0, 0), 2);
  EXPECT_EQ(v.value(1, 1), 30);
  v.blank_row(1);
  EXPECT_EQ(v.value(1, 1), 0);
}

TEST(Column, RevisionFollowsEdits) {
  Columns columns;
  columns.resize(1);
  EXPECT_EQ(columns.revision("a"), 0U);
  columns.add(real_column("a"));
  const Columns copy = columns;
  EXPECT_EQ(copy.revision("a"), columns.revision("a"));
  columns.edit("a")->set(0, 0, 2);
  EXPECT_NE(copy.revision("a"), columns.revision("a"));
  EXPECT_EQ(copy.find("a")->value(0), 0);
}

}  // namespace
}  // namespace lamella::film
