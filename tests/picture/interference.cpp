// The colours of a soap film against the published sequence of orders: C. V. Boys, "Soap Bubbles", and
// Newton's scale of colours.
#include "picture/interference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace lamella::picture {
namespace {

// A name for a hue, from 24 degrees on, in steps; "grey" where there is hardly any.
std::string hue_of(double thickness) {
  const Colour c = reflected_daylight(thickness, 1);
  const double most = std::max({c.red, c.green, c.blue});
  const double least = std::min({c.red, c.green, c.blue});
  if (most < 0.002) return "black";
  if (most - least < 0.15 * most) return "white";
  const double x = c.red - 0.5 * (c.green + c.blue);
  const double y = std::sqrt(3.0) / 2 * (c.green - c.blue);
  double degrees = std::atan2(y, x) * 180 / std::numbers::pi;
  if (degrees < 0) degrees += 360;
  if (degrees < 20 || degrees >= 345) return "red";
  if (degrees < 85) return "yellow";
  if (degrees < 160) return "green";
  if (degrees < 200) return "cyan";
  if (degrees < 265) return "blue";
  return "magenta";
}

TEST(Interference, TheSequenceOfColours) {
  // The first order, after black and white; the second; the third.
  EXPECT_EQ(hue_of(5), "black");
  EXPECT_EQ(hue_of(100), "white");
  EXPECT_EQ(hue_of(150), "yellow");
  EXPECT_EQ(hue_of(170), "yellow");  // brown, as light it is dark orange
  EXPECT_EQ(hue_of(202), "magenta");
  EXPECT_EQ(hue_of(235), "blue");
  EXPECT_EQ(hue_of(300), "green");
  EXPECT_EQ(hue_of(335), "yellow");
  EXPECT_EQ(hue_of(390), "magenta");
  EXPECT_EQ(hue_of(435), "blue");
  EXPECT_EQ(hue_of(500), "green");
  EXPECT_EQ(hue_of(600), "magenta");
  EXPECT_EQ(hue_of(690), "green");
  EXPECT_EQ(hue_of(790), "magenta");
  // The fourth: bluish green and pale red.
  EXPECT_EQ(hue_of(870), "green");
  EXPECT_EQ(hue_of(910), "cyan");
  EXPECT_EQ(hue_of(1000), "red");
}

TEST(Interference, ThickFilmsArePale) {
  const auto contrast = [](double from, double to) {
    double most = 0;
    for (double d = from; d < to; d += 5) {
      const Colour c = reflected_daylight(d, 1);
      const double high = std::max({c.red, c.green, c.blue});
      most = std::max(most, (high - std::min({c.red, c.green, c.blue})) / high);
    }
    return most;
  };
  EXPECT_GT(contrast(300, 600), 0.95);
  EXPECT_LT(contrast(1300, 1500), 0.6);
  EXPECT_LT(contrast(2500, 2600), 0.25);
}

// Half a wave inside the film makes both reflections meet in step: 4 R / (1 + R)^2 of the light for a face's
// R.
TEST(Interference, ReflectanceOfOneWavelength) {
  const double face = std::pow((water_index - 1) / (water_index + 1), 2);
  const double thickness = 550 / (4 * water_index);
  EXPECT_NEAR(reflectance(550, thickness, 1), 4 * face / std::pow(1 + face, 2), 1e-12);
  EXPECT_NEAR(reflectance(550, 2 * thickness, 1), 0, 1e-12);
  double sum = 0;
  const double period = 2 * thickness / std::sqrt(1 - 0.64 / (water_index * water_index));
  for (int i = 0; i < 1000; ++i) sum += reflectance(550, period * i / 1000, 0.6) / 1000;
  EXPECT_NEAR(sum, mean_reflectance(0.6), 1e-9);
}

TEST(Interference, ATiltedFilmLooksThinner) {
  // At 60 degrees outside, the path inside has the cosine sqrt(1 - 0.75 / n^2).
  const double cosine = std::sqrt(1 - 0.75 / (water_index * water_index));
  EXPECT_NEAR(reflectance(500, 250 / water_index / cosine, 0.5), 0, 1e-12);
}

// White in, white out: a mirror of all wavelengths is the screen's white.
TEST(Interference, DaylightIsWhite) {
  double x = 0;
  double y = 0;
  double z = 0;
  for (double w = 380; w <= 780; w += 5) {
    const Tristimulus o = standard_observer(w);
    x += daylight(w) * o.x;
    y += daylight(w) * o.y;
    z += daylight(w) * o.z;
  }
  EXPECT_NEAR(x / y, 0.9505, 0.012);  // the published white point of D65; the fits are good to a percent
  EXPECT_NEAR(z / y, 1.0888, 0.012);
  // The mean over many thicknesses has no colour.
  Colour mean;
  for (int i = 0; i < 4000; ++i) mean = mean + (1 / 4000.0F) * reflected_daylight(2000 + i, 1);
  EXPECT_NEAR(mean.red / mean.green, 1, 0.02);
  EXPECT_NEAR(mean.blue / mean.green, 1, 0.02);
  EXPECT_NEAR(mean.green, mean_reflectance(1), 0.001);
}

TEST(Interference, TheTableHoldsTheRatioToTheMean) {
  const InterferenceTable& table = interference_table();
  ASSERT_EQ(table.colours.size(), static_cast<std::size_t>(table.thicknesses * table.cosines));
  const int column = table.thicknesses / 5;
  const double thickness = table.most_thick * column / (table.thicknesses - 1);
  const Colour head_on =
      table.colours[static_cast<std::size_t>((table.cosines - 1) * table.thicknesses + column)];
  const Colour expected = reflected_daylight(thickness, 1);
  EXPECT_NEAR(head_on.green, expected.green / mean_reflectance(1), 1e-4);
  EXPECT_FLOAT_EQ(table.colours.front().red, 0);  // no film, no reflection
}

}  // namespace
}  // namespace lamella::picture
