// Numbers read straight from bytes.
#include "datafile/plain_numbers.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace lamella::datafile {

namespace {

// The number at the beginning of a text, or -1000 where none stands alone.
double number_in(std::string_view content) {
  double value = 0;
  return plain_number(content, 0, value) > 0 ? value : -1000;
}

TEST(PlainNumber, IsReadWhereItStandsAlone) {
  EXPECT_EQ(number_in("12"), 12);
  EXPECT_EQ(number_in("12 "), 12);
  EXPECT_EQ(number_in("-12,"), -12);
  EXPECT_EQ(number_in("007\r\n"), 7);
  EXPECT_EQ(number_in("1234567890123:"), 1234567890123);
  EXPECT_EQ(number_in(".5;"), 0.5);
  EXPECT_EQ(number_in("-.5e-3\t"), -0.5e-3);
  EXPECT_EQ(number_in("23.}"), 23);
  EXPECT_EQ(number_in("0.30000000000000004\\\n"), 0.1 + 0.2);
  EXPECT_EQ(number_in("5e-324"), 5e-324);
  EXPECT_TRUE(std::signbit(number_in("-0")));
}

TEST(PlainNumber, IsLeftToTheLexerWhereMoreThanANumberStands) {
  for (const char* content :
       {"",   "-",     "- 1",   "+1",  ".",   "1-2",  "1/2", "1(",  "0x10",  "11b", "7D2",
        "2e", "1.2.3", "1e999", "nan", "inf", "-inf", "x",   "1\\", "1/**/", "1//"}) {
    EXPECT_EQ(number_in(content), -1000) << content;
  }
  EXPECT_EQ(number_in(std::string(70000, '1')), -1000);
}

TEST(Blanks, AreSeparatorsAndSplicedLineEnds) {
  EXPECT_EQ(skip_blanks(" \t,:;1", 0), 5U);
  EXPECT_EQ(skip_blanks(" \\\n \\\r\n\\\r1", 0), 9U);
  EXPECT_EQ(skip_blanks(" \n1", 0), 1U);
  EXPECT_EQ(skip_blanks("\\1", 0), 0U);
}

}  // namespace

}  // namespace lamella::datafile
