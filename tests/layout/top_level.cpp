// What lies beside one another at the top: nothing that somebody left there.
#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

TEST(Layout, TheTopLevelHoldsNothingElse) {
  const std::set<std::string> expected = {".ci",
                                          ".clang-format",
                                          ".clang-tidy",
                                          ".gitignore",
                                          "CMakeLists.txt",
                                          "LICENSE",
                                          "CMakePresets.json",
                                          "README.md",
                                          "commands",
                                          "manual",
                                          "datafiles",
                                          "src",
                                          "tests"};
  std::FILE* const pipe = ::popen("git -C " LAMELLA_SOURCE_DIR " ls-tree --name-only HEAD 2> /dev/null", "r");
  ASSERT_NE(pipe, nullptr);
  std::set<std::string> found;
  char line[4096];
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    std::string name = line;
    name.pop_back();
    found.insert(name);
  }
  if (::pclose(pipe) != 0) GTEST_SKIP() << "needs git, and a clone";
  for (const std::string& name : found) EXPECT_EQ(expected.count(name), 1U) << name;
}

}  // namespace
