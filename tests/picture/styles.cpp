// What must hold of each style's pictures, whatever the machine draws: figures of regions, not single pixels.
#include "picture/styles.h"

#include <cmath>

#include <gtest/gtest.h>

#include "picture/scenes.h"
#include "picture/show.h"

namespace lamella::picture {
namespace {

struct Figures {
  double red = 0;
  double green = 0;
  double blue = 0;
  double spread = 0;  // root mean square of the green's distance from its mean

  double saturation() const { return std::max({red, green, blue}) - std::min({red, green, blue}); }
};

// Of a rectangle in parts of the picture's width and height.
Figures figures(const Image& image, double left, double top, double right, double bottom) {
  Figures f;
  double count = 0;
  double squares = 0;
  for (int y = static_cast<int>(top * image.height); y < bottom * image.height; ++y) {
    for (int x = static_cast<int>(left * image.width); x < right * image.width; ++x) {
      const Pixel& p = image.at(x, y);
      f.red += p.red;
      f.green += p.green;
      f.blue += p.blue;
      squares += p.green * p.green;
      count += 1;
    }
  }
  f.red /= count;
  f.green /= count;
  f.blue /= count;
  f.spread = std::sqrt(std::max(0.0, squares / count - f.green * f.green));
  return f;
}

Image picture(std::string_view style, const scene::Scene& scene) {
  PictureOptions options;
  options.width = 120;
  options.height = 120;
  options.style = style_named(style);
  options.view = View{};
  options.view->rotation = looking_from({0.2, -1, 0.3});
  return render(scene, options);
}

scene::Scene bubbles() {
  scene::Scene scene = scenes::double_bubble(8, 1);
  scene.bodies.resize(2);
  return scene;
}

constexpr double corner = 0.08;

TEST(Styles, FilmIsPaleAndColoured) {
  const Image image = picture("film", bubbles());
  const Figures behind = figures(image, 0, 0, corner, corner);
  const Figures left = figures(image, 0.1, 0.4, 0.3, 0.6);
  EXPECT_NEAR(behind.green, 247, 4);
  EXPECT_GT(left.green, 185);
  EXPECT_LT(left.green, 240);
}

TEST(Styles, GlassIsDarkAndGrey) {
  const Image image = picture("glass", bubbles());
  EXPECT_LT(figures(image, 0, 0, corner, corner).green, 75);
  const Figures left = figures(image, 0.1, 0.4, 0.3, 0.6);
  EXPECT_LT(left.green, 110);
  EXPECT_LT(left.saturation(), 30);
}

TEST(Styles, WireShowsTheMeshOnWhite) {
  const Image image = picture("wire", bubbles());
  EXPECT_EQ(figures(image, 0, 0, corner, corner).green, 255);
  const Figures left = figures(image, 0.1, 0.4, 0.3, 0.6);
  EXPECT_GT(left.green, 190);
  EXPECT_GT(left.spread, 5);
}

TEST(Styles, RegionsHaveTheirOwnColours) {
  const Image image = picture("regions", bubbles());
  const Figures left = figures(image, 0.1, 0.4, 0.3, 0.6);
  const Figures right = figures(image, 0.7, 0.4, 0.9, 0.6);
  EXPECT_GT(left.blue, left.red + 40);  // the first colour is a blue, the second an orange
  EXPECT_GT(right.red, right.blue + 40);
}

TEST(Styles, FlatIsOpaque) {
  scenes::Builder b;
  b.patch({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, 2);
  PictureOptions options;
  options.width = options.height = 60;
  options.style = style_named("flat");
  options.view = View{};
  options.style.background_top = options.style.background_bottom = {0, 0, 0};
  const Image on_black = render(b.finish(), options);
  const Figures middle = figures(on_black, 0.3, 0.3, 0.45, 0.45);
  EXPECT_GT(middle.green, 140);
}

TEST(Styles, InterferenceIsSeenInThePicture) {
  PictureOptions options;
  options.width = options.height = 60;
  options.view = View{};
  options.style.film.iridescence = 1;
  options.style.film.opacity = 1;
  options.style.film.highlights = 0;
  options.style.haze = 0;
  const auto seen = [&](double nanometres) {
    scenes::Builder b;
    b.patch({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, 2);
    const scene::Scene scene = b.finish();
    options.content.thickness.assign(scene.film.vertex_rows(), nanometres);
    return figures(render(scene, options), 0.4, 0.4, 0.6, 0.6);
  };
  EXPECT_LT(seen(4).green, 20);  // black film
  const Figures magenta = seen(200);
  EXPECT_GT(magenta.red, magenta.green + 60);
  EXPECT_GT(magenta.blue, magenta.green + 60);
  const Figures green = seen(300);
  EXPECT_GT(green.green, green.blue + 20);
  EXPECT_GT(green.green, green.red + 20);
}

// The number of pixels of a rectangle, in parts of the picture, at which two pictures differ.
int differing(const Image& a, const Image& b, double left, double top, double right, double bottom) {
  int count = 0;
  for (int y = static_cast<int>(top * a.height); y < bottom * a.height; ++y) {
    for (int x = static_cast<int>(left * a.width); x < right * a.width; ++x)
      count += a.at(x, y) == b.at(x, y) ? 0 : 1;
  }
  return count;
}

TEST(Annotations, AreWrittenWhereTheyBelong) {
  PictureOptions options;
  options.width = 240;
  options.height = 180;
  const scene::Scene scene = bubbles();
  options.content.field = ColourField{film::ElementKind::facet, {}, 0, 1, ColourMap::viridis, "area"};
  options.content.field->values.assign(scene.film.triangle_rows(), 0.5);
  const Image plain = render(scene, options);
  options.annotations = {true, true, true, true};
  const Image written = render(scene, options);
  EXPECT_GT(differing(plain, written, 0.10, 0.60, 0.35, 0.85), 50);   // axes
  EXPECT_GT(differing(plain, written, 0.75, 0.90, 1.00, 1.00), 50);   // scale bar
  EXPECT_GT(differing(plain, written, 0.76, 0.25, 0.84, 0.75), 400);  // colour bar
  EXPECT_GT(differing(plain, written, 0.2, 0.4, 0.7, 0.6), 10);       // labels
  EXPECT_EQ(differing(plain, written, 0.0, 0.0, 0.3, 0.3), 0);
}

}  // namespace
}  // namespace lamella::picture
