#include "picture/line_drawing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "picture/scenes.h"
#include "picture/show.h"
#include "picture/styles.h"
#include "text/error.h"

namespace lamella::picture {
namespace {

View from_above() {
  View view;
  view.field_of_view = 0;
  return view;
}

std::vector<Stroke> strokes_of(const scene::Scene& scene, const View& view) {
  const Drawing drawing = draw(scene, Style{});
  return find_strokes(drawing, fit_camera(drawing.outline(), 1e-3, view, 1), 1);
}

double length_of(const std::vector<Stroke>& strokes, LineKind kind, bool hidden) {
  double sum = 0;
  for (const Stroke& stroke : strokes) {
    if (stroke.kind != kind || stroke.hidden != hidden) continue;
    for (std::size_t i = 1; i < stroke.spots.size(); ++i) {
      sum += std::hypot(stroke.spots[i].x - stroke.spots[i - 1].x, stroke.spots[i].y - stroke.spots[i - 1].y);
    }
  }
  return sum;
}

// A wire that runs at half its length under a square film.
TEST(LineDrawing, ALineIsSplitWhereAFilmBeginsToHideIt) {
  scenes::Builder b;
  b.patch({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, 3);
  b.edge(b.vertex({-3, 0.1, -0.5}), b.vertex({0, 0.1, -0.5}));
  b.edge(b.vertex({-3, 0.2, 0.5}), b.vertex({0, 0.2, 0.5}));
  const auto strokes = strokes_of(b.finish(), from_above());
  const double unit = (1 - 2 * margin) / 4;  // the scene is 4 wide
  EXPECT_NEAR(length_of(strokes, LineKind::wire, true), 1 * unit, 2e-3);
  EXPECT_NEAR(length_of(strokes, LineKind::wire, false), (2 + 3) * unit, 2e-3);
  EXPECT_NEAR(length_of(strokes, LineKind::rim, false), 8 * unit, 5e-3);
  EXPECT_EQ(length_of(strokes, LineKind::rim, true), 0);
}

TEST(LineDrawing, TheOutlineOfASphereIsACircle) {
  View view = from_above();
  view.rotation = looking_from({0.31, -0.83, 0.27});  // along no edge of the mesh
  const auto strokes = strokes_of(scenes::sphere(16), view);
  const double radius = 0.5 - margin;
  EXPECT_NEAR(length_of(strokes, LineKind::none, false), 2 * M_PI * radius, 0.1);
  EXPECT_NEAR(length_of(strokes, LineKind::none, true), 0, 0.1);
  for (const Stroke& stroke : strokes) {
    for (const Spot& spot : stroke.spots) EXPECT_NEAR(std::hypot(spot.x - 0.5, spot.y - 0.5), radius, 0.01);
  }
  EXPECT_LE(strokes.size(), 24U);  // joined from hundreds of pieces
}

TEST(LineDrawing, HalfOfTheCircleBetweenTwoBubblesIsHidden) {
  View view;
  view.rotation = looking_from({0.5, -1, 0});
  const auto strokes = strokes_of(scenes::double_bubble(10, 1), view);
  const double seen = length_of(strokes, LineKind::border, false);
  const double hidden = length_of(strokes, LineKind::border, true);
  EXPECT_NEAR(seen / (seen + hidden), 0.5, 0.1);
}

PictureOptions on_paper() {
  PictureOptions options;
  options.width = 200;
  options.height = 150;
  options.style = style_named("paper");
  return options;
}

TEST(LineDrawing, IsMostlyWhiteWithSomeInk) {
  const Image image = render(scenes::wire_cube(4), on_paper());
  int white = 0;
  int black = 0;
  for (const Pixel& p : image.pixels) {
    white += p == Pixel{255, 255, 255, 255} ? 1 : 0;
    black += p.green < 60 ? 1 : 0;
  }
  const auto pixels = static_cast<double>(image.pixels.size());
  EXPECT_GT(white, 0.75 * pixels);
  EXPECT_GT(black, 0.004 * pixels);
}

TEST(LineDrawing, IsWrittenAsSvgAndPdf) {
  const scene::Scene scene = scenes::wire_cube(3);
  const std::string svg = encode_picture(scene, FileKind::svg, on_paper());
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
  EXPECT_EQ(svg.find("<image"), std::string::npos);  // lines, not pixels
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  const std::string pdf = encode_picture(scene, FileKind::pdf, on_paper());
  EXPECT_EQ(pdf.rfind("%PDF-", 0), 0U);
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
}

TEST(LineDrawing, EndingsTellTheKindOfFile) {
  EXPECT_EQ(file_kind("a/b.PNG"), FileKind::png);
  EXPECT_EQ(file_kind("picture"), FileKind::png);
  EXPECT_EQ(file_kind("a.svg"), FileKind::svg);
  EXPECT_EQ(file_kind("a.html"), FileKind::html);
  EXPECT_THROW(file_kind("a.jpg"), text::Error);
}

}  // namespace
}  // namespace lamella::picture
