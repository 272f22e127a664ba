// Every file is laid out as .clang-format says (version 14, the one of Debian 12; skipped where it is
// missing).
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

std::string output_of(const std::string& command) {
  std::string output;
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe))
    output.append(block.data(), count);
  pclose(pipe);
  return output;
}

TEST(Layout, FilesAreFormatted) {
  if (output_of("clang-format --version 2>/dev/null").find("version 14") == std::string::npos) {
    GTEST_SKIP() << "clang-format 14 is not installed";
  }
  std::string files;
  for (const char* folder : {"src", "commands", "tests"}) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(LAMELLA_SOURCE_DIR) / folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".cpp" || ending == ".h") files += " '" + entry.path().string() + "'";
    }
  }
  const std::string complaints =
      output_of("clang-format --dry-run " + files + " 2>&1 | grep warning: | cut -d: -f1 | sort -u");
  EXPECT_EQ(complaints, "");
}

}  // namespace
