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

std::string expectation_path(const std::string& datafile) {
  return files::path(datafile).replace_extension(".expected");
}

void check_messages(const std::string& path) {
  SCOPED_TRACE(path);
  const std::string stem = files::path(path).stem();
  ASSERT_TRUE(files::exists(expectation_path(path)));
  Expectation expected = read_expectation(expectation_path(path));
  if (std::find(found_by_the_session.begin(), found_by_the_session.end(), stem) !=
      found_by_the_session.end()) {
    expected = {};
  }
  try {
    const datafile::ReadResult result = datafile::read_datafile(path);
    EXPECT_EQ(expected.status, 0) << "it loads";
    EXPECT_EQ(difference(expected.messages, result.warnings, path), "");
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
    EXPECT_EQ(difference(expected.messages, error.diagnostics(), path), "");
  }
}

class ExpectedMessages : public testing::TestWithParam<const char*> {};

TEST_P(ExpectedMessages, AreAllAndInOrder) {
  for (const std::string& path : datafiles_in(std::string("datafiles/") + GetParam())) check_messages(path);
}

INSTANTIATE_TEST_SUITE_P(Folders, ExpectedMessages, testing::Values("broken", "unsupported", "tricky"));

}  // namespace

}  // namespace lamella::test
