// Sessions written down: what is typed, and what must come back.
//
//   # options -q datafiles/cube.fe      arguments of the program; datafiles/ is the project's
//   # tolerance 1e-6                    of numbers, relative, from here on (1e-9 at the start)
//   > print total_area                  typed
//   6                                   printed (messages too)
//   ...                                 any lines, also none
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

struct Expected {
  std::string line;
  double tolerance = 1e-9;
};

struct Transcript {
  std::string options;
  std::string typed;
  std::vector<Expected> output;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

Transcript parse(const std::string& text) {
  Transcript result;
  double tolerance = 1e-9;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("# options ")) {
      result.options = line.substr(10);
    } else if (line.starts_with("# tolerance ")) {
      tolerance = std::stod(line.substr(12));
    } else if (line.starts_with("> ") || line == ">") {
      result.typed += (line.size() > 2 ? line.substr(2) : "") + "\n";
    } else if (!line.starts_with("#") && !line.empty()) {
      result.output.push_back({line, tolerance});
    }
  }
  return result;
}

const std::regex& number_or_word() {
  static const std::regex pattern(R"([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?|[^\s\d.+-]+|[^\s])");
  return pattern;
}

std::vector<std::string> parts_of(const std::string& line) {
  return {std::sregex_token_iterator(line.begin(), line.end(), number_or_word()),
          std::sregex_token_iterator()};
}

bool is_number(const std::string& part) {
  return part.find_first_of("0123456789") != std::string::npos;
}

// Spaces do not count, numbers are compared by value.
bool agree(const Expected& expected, const std::string& line) {
  const std::vector<std::string> wanted = parts_of(expected.line);
  const std::vector<std::string> found = parts_of(line);
  return std::equal(
      wanted.begin(), wanted.end(), found.begin(), found.end(),
      [&](const std::string& a, const std::string& b) {
        if (!is_number(a) || !is_number(b)) return a == b;
        const double x = std::stod(a);
        const double y = std::stod(b);
        return std::abs(x - y) <= expected.tolerance * std::max({std::abs(x), std::abs(y), 1e-300});
      });
}

// Matches line by line; a line `...` takes as many as it must. Returns the first line that has no partner, or
// nothing.
std::string first_difference(const std::vector<Expected>& expected, const std::vector<std::string>& found) {
  std::size_t j = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i].line == "...") {
      if (i + 1 == expected.size()) return {};
      while (j < found.size() && !agree(expected[i + 1], found[j])) ++j;
      continue;
    }
    const std::string line = j < found.size() ? found[j] : "(nothing more)";
    if (j >= found.size() || !agree(expected[i], line))
      return "expected: " + expected[i].line + "\nfound:    " + line;
    ++j;
  }
  return j < found.size() ? "expected: (nothing more)\nfound:    " + found[j] : std::string{};
}

class Transcripts : public ::testing::TestWithParam<std::string> {};

TEST_P(Transcripts, HoldsToTheLetter) {
  const fs::path root = LAMELLA_SOURCE_DIR;
  const Transcript transcript = parse(content_of(root / "tests/transcripts" / (GetParam() + ".txt")));
  ASSERT_FALSE(transcript.typed.empty());
  std::string folder_name = (fs::temp_directory_path() / "lamella-transcript-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder_name.data()), nullptr);
  const fs::path folder = folder_name;
  fs::create_directory_symlink(root / "datafiles", folder / "datafiles");
  std::ofstream(folder / "typed") << transcript.typed;
  const std::string command = "cd '" + folder_name + "' && '" LAMELLA_BINARY "' --keep-going " +
                              transcript.options + " < typed > printed 2>&1";
  const int status = std::system(command.c_str());
  const std::string printed = content_of(folder / "printed");
  fs::remove_all(folder);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) <= 1) << printed;
  std::vector<std::string> found = lines_of(printed);
  std::erase(found, "");
  EXPECT_EQ(first_difference(transcript.output, found), "") << "all that was printed:\n" << printed;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(LAMELLA_SOURCE_DIR) / "tests/transcripts")) {
    if (entry.path().extension() == ".txt") result.push_back(entry.path().stem().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, Transcripts, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

// The comparison itself must be able to fail.
TEST(TranscriptComparison, TellsNumbersAndWordsApart) {
  EXPECT_TRUE(agree({"area 9.139", 1e-3}, "area   9.1391"));
  EXPECT_FALSE(agree({"area 9.139", 1e-6}, "area   9.1391"));
  EXPECT_FALSE(agree({"area 1", 1}, "volume 1"));
  EXPECT_FALSE(agree({"1 2", 1e-9}, "1"));
  EXPECT_TRUE(agree({"0", 1e-9}, "0"));
  EXPECT_FALSE(agree({"0", 1e-9}, "1e-12"));
  EXPECT_NE(first_difference({{"1"}, {"2"}}, {"1"}), "");
  EXPECT_NE(first_difference({{"1"}}, {"1", "2"}), "");
  EXPECT_EQ(first_difference({{"1"}, {"..."}, {"4"}}, {"1", "2", "3", "4"}), "");
  EXPECT_NE(first_difference({{"1"}, {"..."}, {"5"}}, {"1", "2", "3", "4"}), "");
}

}  // namespace
