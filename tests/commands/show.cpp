#include "support/trial.h"

namespace lamella::trial {
namespace {

bool is_png(const std::string& path) {
  return file_content(path).starts_with("\x89PNG");
}

// Width and height as a PNG file tells them.
std::pair<int, int> size_of(const std::string& path) {
  const std::string bytes = file_content(path);
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST(Show, WritesAPicture) {
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("show " + (folder / "a-b.2.png") + " width 64 height=48 from (1, -2, 0.5) zoom 1.5 samples 1");
  EXPECT_TRUE(is_png(folder / "a-b.2.png"));
  trial.out("name := \"" + (folder / "b.png") + "\"; show name size=32x24 transparent");
  EXPECT_EQ(size_of(folder / "b.png"), std::pair(32, 24));
}

TEST(Show, TakesTheWordsOfAPicture) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  const std::string file = folder / "a.png";
  const auto show = [&](const std::string& words) {
    std::filesystem::remove(file);
    trial.out("show \"" + file + "\" size=80x60 samples 1 " + words);
    EXPECT_TRUE(is_png(file)) << words;
    return file_content(file);
  };
  const std::string plain = show("");
  for (const char* style : {"glass", "paper", "wire", "regions", "flat"})
    EXPECT_NE(show("style=" + std::string(style)), plain) << style;
  EXPECT_EQ(show("style=film"), plain);
  for (const char* words :
       {"color=area", "color=vertex z^2", "color=length range (0, 3) map diverging", "thickness=250",
        "thickness=vertex 300+100*z", "drain (10, 900)", "view top", "rotate (30, 20, 0)", "pan (0.2, 0)",
        "lens 0", "clip (1, 0, 0, 0)", "explode 0.3", "line_width 3", "axes", "scale_bar", "labels",
        "background=#203040", "background none", "background=red"}) {
    EXPECT_NE(show(words), plain) << words;
  }
}

TEST(Show, DrawsTheFacetsThatArePickedOut) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  trial.out("show facets where valence > 0 \"" + (folder / "all.png") + "\" size=40x30");
  trial.out("show facet where id == 1 \"" + (folder / "one.png") + "\" size=40x30");
  EXPECT_NE(file_content(folder / "all.png"), file_content(folder / "one.png"));
  EXPECT_TRUE(contains(trial.failure("show facets where area > 1000 a.png"), "no facet is like that"));
  EXPECT_TRUE(contains(trial.failure("show vertices a.png"), "facets, not vertices"));
}

TEST(Show, Refuses) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("show"), "nothing to show"));
  trial.session().load(datafile("cube.fe"));
  EXPECT_TRUE(contains(trial.failure("show a.png width 0"), "at least 1"));
  EXPECT_TRUE(contains(trial.failure("show a.png size=0x10"), "1 to 16384"));
  EXPECT_TRUE(contains(trial.failure("show a.png size=0"), "1 to 16384"));
  EXPECT_TRUE(contains(trial.failure("show a.png size=100000"), "1 to 16384"));
  EXPECT_TRUE(contains(trial.failure("show a.png size=99999999999x1"), "1 to 16384"));
  EXPECT_TRUE(contains(trial.failure("show a.png size=large"), "1600x1200"));
  EXPECT_TRUE(contains(trial.failure("show a.png style=glas"), "did you mean \"glass\"?"));
  EXPECT_TRUE(contains(trial.failure("show a.png background=yelow"), "did you mean \"yellow\"?"));
  EXPECT_TRUE(contains(trial.failure("show a.png view=tpo"), "did you mean \"top\"?"));
  EXPECT_TRUE(contains(trial.failure("show a.png color=arae"), "arae"));
  EXPECT_TRUE(contains(trial.failure("show a.png color=area range (2, 1)"), "empty"));
  EXPECT_TRUE(contains(trial.failure("show a.png clip (0, 0, 0, 1)"), "no plane"));
  EXPECT_TRUE(contains(trial.failure("show a.png clip (1, 0, 0, -100)"), "cuts everything away"));
  EXPECT_TRUE(contains(trial.failure("show a.png thickness=-5"), "-5 nm"));
  EXPECT_TRUE(contains(trial.failure("show a.png from (0, 0, 0)"), "no direction"));
  EXPECT_TRUE(contains(trial.failure("show a.png from (1, 0)"), "takes 3 numbers"));
  EXPECT_TRUE(contains(trial.failure("show a.png widht 5"), "did you mean \"width\"?"));
  EXPECT_TRUE(contains(trial.failure("show /no/such/folder/a.png size=8"), "/no/such/folder/a.png"));
  EXPECT_FALSE(std::filesystem::exists("a.png"));
}

}  // namespace
}  // namespace lamella::trial
