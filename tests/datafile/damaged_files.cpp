// Whatever happens to a datafile, reading it ends in a scene or in an error.
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "datafile/read.h"
#include "film/check.h"
#include "text/whole_file.h"

namespace lamella::test {

namespace {

std::string path_of(const std::string& file) {
  return std::string(LAMELLA_SOURCE_DIR) + "/datafiles/" + file;
}

// Reads, and expects a sound film or an error that says something.
void expect_scene_or_error(const std::string& name, const std::string& content) {
  try {
    const datafile::ReadResult result = datafile::read_datafile(text::make_source(name, content));
    ASSERT_EQ(film::check(result.scene.film), std::vector<std::string>{}) << content;
  } catch (const text::Error& error) {
    ASSERT_FALSE(error.diagnostics().empty()) << content;
    ASSERT_LE(error.diagnostics().size(), 21U) << content;
    for (const text::Diagnostic& diagnostic : error.diagnostics()) {
      ASSERT_FALSE(diagnostic.message.empty()) << content;
      if (!diagnostic.place.known()) continue;
      ASSERT_LE(diagnostic.place.offset, diagnostic.place.source->content.size());
    }
  }
}

class DamagedFiles : public testing::TestWithParam<const char*> {};

TEST_P(DamagedFiles, MayBeCutAnywhere) {
  const std::string path = path_of(GetParam());
  const std::string content = text::read_whole_file(path);
  for (std::size_t length = 0; length < content.size(); ++length) {
    expect_scene_or_error(path, content.substr(0, length));
    if (HasFatalFailure()) return;
  }
}

TEST_P(DamagedFiles, MayBeChangedAnywhere) {
  const std::string path = path_of(GetParam());
  const std::string content = text::read_whole_file(path);
  const std::string alphabet = "0123456789-+.,;:/*\\\"#(){}[]=\n\r\t aefrsvxEIN\x01\x80\xff";
  std::mt19937 random(20240607);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  for (int run = 0; run < 400; ++run) {
    std::string changed = content;
    for (std::size_t change = 0, changes = 1 + below(4); change < changes; ++change) {
      const std::size_t at = below(changed.size());
      const std::size_t length = std::min(1 + below(40), changed.size() - at);
      switch (below(4)) {
        case 0:
          changed[at] = alphabet[below(alphabet.size())];
          break;
        case 1:
          changed.erase(at, length);
          break;
        case 2:
          changed.insert(at, content.substr(below(content.size()), length));
          break;
        default:
          changed.insert(at, 1, alphabet[below(alphabet.size())]);
          break;
      }
      if (changed.empty()) changed.push_back(' ');
    }
    expect_scene_or_error(path, changed);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, DamagedFiles,
                         testing::Values("cube.fe", "tricky/attributes.fe", "tricky/cosmetic_words.fe",
                                         "tricky/formulas_everywhere.fe", "tricky/nested_define.fe",
                                         "tricky/include_vertices.fe", "tricky/comments.fe", "tricky/seam.fe",
                                         "tricky/continuation.fe", "tricky/singular_sections.fe",
                                         "tricky/constraint_integrals.fe", "tricky/boundaries.fe"));

TEST(DamagedFiles, MayNestDeeply) {
  constexpr int depth = 100000;
  expect_scene_or_error("deep.fe", fmt::format("vertices\n1 {:(<{}}\n", "", depth));
  expect_scene_or_error("deep.fe", fmt::format("parameter aa = {:(<{}}\n", "", depth));
  expect_scene_or_error("deep.fe", fmt::format("vertices\n1 {:-<{}}1 0 0\n", "", depth));
  const std::string braces(depth, '{');
  expect_scene_or_error("deep.fe",
                        fmt::format("define vertex attribute aa real[2]\nvertices\n1 0 0 0 aa {}\n", braces));
  expect_scene_or_error("deep.fe", fmt::format("clip_coeff = {}\n", braces));
}

TEST(DamagedFiles, MayGrowByMacros) {
  std::string content = "#define A0 1 1\n";
  for (int i = 1; i < 60; ++i) content += fmt::format("#define A{} A{} A{}\n", i, i - 1, i - 1);
  expect_scene_or_error("macros.fe", content + "vertices\n1 A59\n");
}

TEST(DamagedFiles, MayHaveVeryLongLines) {
  expect_scene_or_error("long.fe", fmt::format("vertices\n1 0{: <{}}0 0\n2 {:1<{}} 0 0\n3 0.{:0<{}}1 0 0\n",
                                               "", 3000000, "", 300000, "", 300000));
}

}  // namespace

}  // namespace lamella::test
