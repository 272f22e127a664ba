// The string model: films of one dimension.
#include <cmath>

#include "support/trial.h"

namespace lamella::session {
namespace {

constexpr const char* square = R"(string
space_dimension 2
vertices
1 0 0
2 1 0
3 1 1
4 0 1
edges
1 1 2
2 2 3
3 3 4
4 4 1
faces
1 1 2 3 4
bodies
1 1 volume 1
)";

class Strings : public testing::Test {
 protected:
  void load(trial::Trial& trial, const std::string& text) {
    trial.out("load \"" + folder_.write("scene.fe", text) + "\"");
  }
  trial::Folder folder_;
};

TEST_F(Strings, ABubbleInThePlaneBecomesARegularPolygon) {
  trial::Trial trial;
  load(trial, square);
  EXPECT_EQ(trial.number("facet_count"), 1);
  EXPECT_EQ(trial.number("total_energy"), 4);
  EXPECT_EQ(trial.number("body[1].volume"), 1);
  trial.out("refine; refine; g 200; hessian; hessian; V; g 50; hessian; hessian");
  const double n = 16;
  EXPECT_NEAR(trial.number("total_length"), 2 * std::sqrt(n * std::tan(M_PI / n)), 1e-6);
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-13);
  // the pressure of a circle: tension over radius
  EXPECT_NEAR(trial.number("body[1].pressure"), std::sqrt(M_PI), 0.03);
}

TEST_F(Strings, IsSavedAsItIs) {
  trial::Trial trial;
  load(trial, square);
  trial.out("refine; g 3; save \"" + folder_ / "saved.fe" + "\"");
  trial::Trial again;
  again.out("load \"" + folder_ / "saved.fe" + "\"");
  EXPECT_EQ(again.number("total_energy"), trial.number("total_energy"));
  EXPECT_NEAR(again.number("body[1].volume"), 1, 1e-13);
  EXPECT_EQ(again.number("facet_count"), 1);
}

// Contents at the ends of a chain are differences of an antiderivative.
TEST_F(Strings, AWallClosesABody) {
  trial::Trial trial;
  load(trial, R"(string
space_dimension 2
constraint 1
formula: y = x^2
content: c1: x^3/3
vertices
1 1 1 constraint 1
2 0 2
3 -1 1 constraint 1
edges
1 1 2
2 2 3
faces
1 1 2
bodies
1 1
)");
  // the triangle over y = 1, and the bowl of 4/3 below it
  EXPECT_NEAR(trial.number("body[1].volume"), 1 + 4.0 / 3, 1e-13);
}

TEST_F(Strings, WeightIsTheIntegralOfHeight) {
  trial::Trial trial;
  std::string text = square;
  text.replace(text.find("volume 1"), 8, "volume 1 density 2");
  load(trial, text);
  trial.out("G 3");
  EXPECT_NEAR(trial.number("total_energy"), 4 + 2 * 3 * 0.5, 1e-13);
}

// Two cells side by side in a periodic strip, across its seam.
TEST_F(Strings, CellsOfAPeriodicPlane) {
  trial::Trial trial;
  load(trial, R"(string
space_dimension 2
torus
periods
1 0
0 1
vertices
1 0.25 0
2 0.75 0
edges
1 1 1 * +
2 2 2 * +
3 1 2 * *
4 2 1 + *
faces
1 3 2 -3 -1
2 4 1 -4 -2
bodies
1 1
2 2
)");
  EXPECT_NEAR(trial.number("body[1].volume"), 0.5, 1e-14);
  EXPECT_NEAR(trial.number("body[2].volume"), 0.5, 1e-14);
  EXPECT_EQ(trial.number("total_length"), 3);
}

TEST_F(Strings, FixedQuantitiesAreHeld) {
  trial::Trial trial;
  std::string text = square;
  text.replace(text.find("vertices"), 0,
               "quantity rise fixed = 0.7 method vertex_scalar_integral\nscalar_integrand: y\n");
  text.replace(text.find("3 1 1"), 5, "3 1 1 rise");
  load(trial, text);
  trial.out("g 100");
  EXPECT_NEAR(trial.number("rise.value"), 0.7, 1e-12);
  EXPECT_NEAR(trial.number("vertex[3].y"), 0.7, 1e-12);
  EXPECT_NE(trial.number("rise.pressure"), 0);
}

}  // namespace
}  // namespace lamella::session
