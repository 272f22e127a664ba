// The arrows between the folders of src point down only: what CMake links is what the files include.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> allowed = {
    {"text", {}},
    {"film", {}},
    {"language", {"text"}},
    {"scene", {"film", "language", "text"}},
    {"energy", {"scene", "film", "language", "text"}},
    {"solve", {"energy", "scene", "film", "language", "text"}},
    {"surgery", {"energy", "scene", "film", "language", "text"}},
    {"air", {"scene", "film", "language", "text"}},
    {"evolution", {"air", "solve", "surgery", "energy", "scene", "film", "language", "text"}},
    {"datafile", {"scene", "film", "language", "text"}},
    {"picture", {"scene", "film", "language", "text"}},
    {"exchange", {"datafile", "picture", "scene", "film", "language", "text"}},
    {"chart",
     {"air", "datafile", "evolution", "solve", "surgery", "energy", "scene", "film", "language", "text"}},
    {"session",
     {"air", "chart", "exchange", "datafile", "evolution", "picture", "solve", "surgery", "energy", "scene",
      "film", "language", "text"}},
};

// The folders named in the quoted includes of a file.
std::set<std::string> included_folders(const fs::path& file) {
  static const std::regex include(R"(^\s*#\s*include\s+\"([a-z_]+)/)");
  std::set<std::string> folders;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include)) folders.insert(match[1]);
  }
  return folders;
}

TEST(Layout, IncludesPointDown) {
  const fs::path src = fs::path(LAMELLA_SOURCE_DIR) / "src";
  int files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
    if (!entry.is_regular_file() || entry.path().parent_path() == src) continue;
    const std::string folder = fs::relative(entry.path(), src).begin()->string();
    ASSERT_TRUE(allowed.contains(folder)) << "src/" << folder << " is not in the plan of the layout";
    ++files;
    for (const std::string& included : included_folders(entry.path())) {
      EXPECT_TRUE(included == folder || allowed.at(folder).contains(included))
          << entry.path() << " includes " << included << "/, which does not lie below " << folder << "/";
    }
  }
  EXPECT_GT(files, 20);
}

TEST(Layout, EveryCommandHasATestAndAPage) {
  const fs::path root = LAMELLA_SOURCE_DIR;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "commands")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(fs::exists(root / "manual/commands" / (name + ".md")))
        << "commands/" << name << ".cpp has no page";
    bool tested = false;
    for (const fs::directory_entry& test : fs::directory_iterator(root / "tests/commands")) {
      tested = tested || test.path().stem() == name;
    }
    EXPECT_TRUE(tested) << "commands/" << name << ".cpp has no test in tests/commands";
  }
}

}  // namespace
