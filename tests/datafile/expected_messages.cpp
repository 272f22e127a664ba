// Every file of datafiles/broken, unsupported and tricky says exactly what stands in its .expected file.
#include <array>
#include <filesystem>

#include <gtest/gtest.h>

#include "datafile/expectation.h"
#include "datafile/measures.h"
#include "datafile/read.h"
#include "film/check.h"

namespace lamella::test {

namespace {

namespace files = std::filesystem;

// Their mistakes stand after `read`, which the session runs.
constexpr std::array<std::string_view, 3> found_by_the_session = {"extra_brace", "missing_brace",
                                                                  "unknown_command_in_read"};

class ExpectedMessages : public testing::TestWithParam<std::string> {};

std::string expectation_path(const std::string& datafile) {
  return files::path(datafile).replace_extension(".expected");
}

TEST_P(ExpectedMessages, AreAllAndInOrder) {
  const std::string stem = files::path(GetParam()).stem();
  ASSERT_TRUE(files::exists(expectation_path(GetParam())));
  Expectation expected = read_expectation(expectation_path(GetParam()));
  if (std::find(found_by_the_session.begin(), found_by_the_session.end(), stem) !=
      found_by_the_session.end()) {
    expected = {};
  }
  try {
    const datafile::ReadResult result = datafile::read_datafile(GetParam());
    EXPECT_EQ(expected.status, 0) << "it loads";
    EXPECT_EQ(difference(expected.messages, result.warnings, GetParam()), "");
    EXPECT_EQ(film::check(result.scene.film), std::vector<std::string>{});
    const film::Film& film = result.scene.film;
    const std::vector<std::uint32_t> counts{film.vertex_count(), film.edge_count(), film.triangle_count(),
                                            body_count(result.scene)};
    if (!expected.counts.empty()) {
      EXPECT_EQ(counts, expected.counts);
    }
    if (expected.area) {
      EXPECT_NEAR(area(result.scene), *expected.area, 1e-12 * *expected.area);
    }
  } catch (const text::Error& error) {
    EXPECT_EQ(expected.status, 2) << error.what();
    EXPECT_EQ(difference(expected.messages, error.diagnostics(), GetParam()), "");
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  return files::path(info.param).stem();
}

INSTANTIATE_TEST_SUITE_P(Broken, ExpectedMessages, testing::ValuesIn(datafiles_in("datafiles/broken")),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Unsupported, ExpectedMessages,
                         testing::ValuesIn(datafiles_in("datafiles/unsupported")), test_name);
INSTANTIATE_TEST_SUITE_P(Tricky, ExpectedMessages, testing::ValuesIn(datafiles_in("datafiles/tricky")),
                         test_name);

}  // namespace

}  // namespace lamella::test
