// A hundred thousand facets.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "datafile/measures.h"
#include "datafile/read.h"
#include "datafile/same_scene.h"
#include "datafile/write.h"

namespace lamella::test {

namespace {

// A ring of n x m vertices, each with three edges and two faces, around one body.
std::string ring(int n, int m) {
  std::string text = "vertices\n";
  const auto vertex = [&](int i, int j) { return (i % n) * m + j % m + 1; };
  const int count = n * m;
  const auto each = [&](auto&& function) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < m; ++j) function(i, j, vertex(i, j));
    }
  };
  each([&](int i, int j, int v) {
    const double a = 2 * M_PI * i / n;
    const double b = 2 * M_PI * j / m;
    text += fmt::format("{} {} {} {}\n", v, (2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a),
                        std::sin(b));
  });
  text += "edges\n";
  each([&](int i, int j, int v) { text += fmt::format("{} {} {}\n", v, v, vertex(i + 1, j)); });
  each([&](int i, int j, int v) { text += fmt::format("{} {} {}\n", count + v, v, vertex(i, j + 1)); });
  each([&](int i, int j, int v) {
    text += fmt::format("{} {} {}\n", 2 * count + v, v, vertex(i + 1, j + 1));
  });
  text += "faces\n";
  each([&](int i, int j, int v) {
    text += fmt::format("{} {} {} -{}\n", v, v, count + vertex(i + 1, j), 2 * count + v);
  });
  each([&](int i, int j, int v) {
    text += fmt::format("{} {} -{} -{}\n", count + v, 2 * count + v, vertex(i, j + 1), count + v);
  });
  text += "bodies\n1";
  for (int f = 1; f <= 2 * count; ++f) text += fmt::format("{}{}", f % 10 == 0 ? " \\\n " : " ", f);
  return text + " volume 39\n";
}

TEST(LargeFile, LoadsAndComesBackTheSame) {
  const auto loaded = datafile::read_datafile(text::make_source("ring.fe", ring(250, 200)));
  EXPECT_TRUE(loaded.warnings.empty()) << text::render(loaded.warnings);
  const scene::Scene& scene = loaded.scene;
  EXPECT_EQ(scene.film.vertex_count(), 50000U);
  EXPECT_EQ(scene.film.edge_count(), 150000U);
  EXPECT_EQ(scene.film.triangle_count(), 100000U);
  EXPECT_NEAR(area(scene), 8 * M_PI * M_PI, 0.02);
  EXPECT_NEAR(volume(scene, {1}), 4 * M_PI * M_PI, 0.02);
  const auto again = datafile::read_datafile(text::make_source("saved.fe", datafile::write_datafile(scene)));
  EXPECT_EQ(first_difference(scene, again.scene), "");
}

// Both ways of reading numbers, from bytes and as tokens, give the same.
TEST(LargeFile, IsTheSameWithCommentsBetweenNumbers) {
  const std::string plain = ring(20, 10);
  std::string commented;
  for (const char c : plain) commented.append(c == ' ' ? " /**/ " : std::string(1, c));
  const auto a = datafile::read_datafile(text::make_source("plain.fe", plain));
  const auto b = datafile::read_datafile(text::make_source("commented.fe", commented));
  EXPECT_EQ(first_difference(a.scene, b.scene), "");
}

}  // namespace

}  // namespace lamella::test
