// Facts about pixels. Pictures are small: software rendering under sanitizers takes its time.
#include "picture/show.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <unistd.h>

#include "picture/decode_png.h"
#include "picture/drawing.h"
#include "picture/scenes.h"
#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::picture {
namespace {

using film::Vec3;

PictureOptions small() {
  PictureOptions options;
  options.width = 160;
  options.height = 120;
  return options;
}

// Films whose layer is known: they reflect a grey of light `grey` by `opacity` at every angle.
Style plain_style(double opacity, float grey) {
  Style style;
  const Colour colour{grey, grey, grey};
  style.surroundings = {colour, colour, colour};
  style.background_top = style.background_bottom = {0.9F, 0.5F, 0.1F};
  style.film.opacity = style.film.grazing = opacity;
  style.film.iridescence = 0;
  style.film.highlights = 0;
  style.haze = 0;
  return style;
}

View from_above() {
  View view;
  view.field_of_view = 0;
  return view;
}

int distance(const Pixel& a, const Pixel& b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

// Where a point of the scene appears in a picture.
struct Place {
  int x = 0;
  int y = 0;
};

Place place_of(const Vec3& point, const scene::Scene& scene, const PictureOptions& options) {
  const Drawing drawing = draw(scene, options.style);
  const View view = options.view ? *options.view : view_of(scene);
  const Camera camera = fit_camera(drawing.outline(), drawing.largest_tube(), view,
                                   static_cast<double>(options.width) / options.height);
  const Point p = drawing.place(point);
  const Vec3 seen = camera.project({p[0], p[1], p[2]});
  return {static_cast<int>((seen.x + 1) / 2 * options.width),
          static_cast<int>((1 - seen.y) / 2 * options.height)};
}

Pixel pixel_at(const Image& image, const Place& place) {
  return image.at(place.x, place.y);
}

// The byte of the light that n films let through and add, one behind the other.
int expected_byte(double light, double opacity, double grey, int films) {
  for (int i = 0; i < films; ++i) light = opacity * grey + (1 - opacity) * light;
  return srgb_byte(static_cast<float>(light));
}

TEST(Show, BackgroundIsTheStylesGradientAndTheSceneIsInTheMiddle) {
  const PictureOptions options = small();
  const Image image = render(scenes::sphere(8), options);
  const auto expected = [&](double down) {
    const Colour c =
        mix(options.style.background_top, options.style.background_bottom, static_cast<float>(down));
    return Pixel{srgb_byte(c.red), srgb_byte(c.green), srgb_byte(c.blue), 255};
  };
  EXPECT_LE(distance(image.at(0, 0), expected(0.5 / 120)), 1);
  EXPECT_LE(distance(image.at(159, 0), expected(0.5 / 120)), 1);
  EXPECT_LE(distance(image.at(0, 119), expected(119.5 / 120)), 1);
  int covered = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) covered += distance(image.at(x, y), expected((y + 0.5) / 120)) > 2 ? 1 : 0;
  }
  // A disc nearly as high as the picture less its margins.
  const double disc = M_PI * std::pow(0.5 * 120 * (1 - 2 * margin), 2);
  EXPECT_GT(covered, 0.9 * disc);
  EXPECT_LT(covered, 1.02 * disc);
}

TEST(Show, FilmsBlendByTheFormula) {
  PictureOptions options = small();
  options.style = plain_style(0.3, 0.2F);
  options.view = from_above();
  const scene::Scene scene = scenes::two_square_films(3);
  const Image image = render(scene, options);
  const Colour behind = options.style.background_top;
  const std::pair<Vec3, int> places[] = {
      {{-0.6, -0.7, 0}, 1}, {{1.5, 1.6, 0.5}, 1}, {{0.45, 0.6, 0.2}, 2}, {{1.6, -0.6, 0}, 0}};
  for (const auto& [point, films] : places) {
    const Pixel seen = pixel_at(image, place_of(point, scene, options));
    EXPECT_NEAR(seen.red, expected_byte(behind.red, 0.3, 0.2, films), 1) << films;
    EXPECT_NEAR(seen.green, expected_byte(behind.green, 0.3, 0.2, films), 1) << films;
    EXPECT_NEAR(seen.blue, expected_byte(behind.blue, 0.3, 0.2, films), 1) << films;
  }
}

TEST(Show, ManyFilmsBehindOneAnother) {
  PictureOptions options = small();
  options.style = plain_style(0.05, 0.6F);
  options.view = from_above();
  scenes::Builder b;
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    const double z = 0.01 * ((i * 37) % count);  // made in no order of depth
    b.patch({-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}, 1);
  }
  const scene::Scene scene = b.finish();
  const Pixel seen = pixel_at(render(scene, options), place_of({0.3, 0.2, 0}, scene, options));
  EXPECT_NEAR(seen.red, expected_byte(options.style.background_top.red, 0.05, 0.6, count), 2);
  EXPECT_NEAR(seen.blue, expected_byte(options.style.background_top.blue, 0.05, 0.6, count), 2);
}

scene::Scene red_above_blue() {
  scenes::Builder b;
  for (const double z : {0.0, 0.4}) b.patch({-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}, 1);
  scene::Scene scene = b.finish();
  film::Column& colour = scene.film.columns(film::ElementKind::facet).add(film::integer_column("color", 15));
  for (std::uint32_t t = 0; t < 4; ++t) colour.set(t, 0, t < 2 ? 1 : 4);
  return scene;
}

TEST(Show, TheNearerColourPrevails) {
  PictureOptions options = small();
  options.style = plain_style(0.1, 0.5F);
  options.style.background_top = options.style.background_bottom = {1, 1, 1};
  options.style.film.tint_opacity = 0.7;
  const scene::Scene scene = red_above_blue();
  options.view = from_above();
  const Pixel above = pixel_at(render(scene, options), place_of({0.2, 0.3, 0}, scene, options));
  options.view->rotation = looking_from({0, 0, -1});
  const Pixel below = pixel_at(render(scene, options), place_of({0.2, 0.3, 0}, scene, options));
  EXPECT_GT(above.red, above.blue + 40);
  EXPECT_GT(below.blue, below.red + 40);
}

TEST(Show, AFacetMayHaveTwoColours) {
  PictureOptions options = small();
  options.style = plain_style(0.1, 0.5F);
  options.style.film.tint_opacity = 0.7;
  scene::Scene scene = scenes::square_film(2);
  film::Columns& columns = scene.film.columns(film::ElementKind::facet);
  columns.add(film::integer_column("color", 4));
  columns.add(film::integer_column("backcolor", 1));
  options.view = from_above();
  const Pixel front = pixel_at(render(scene, options), place_of({0.2, 0.3, 0}, scene, options));
  options.view->rotation = looking_from({0, 0, -1});
  const Pixel back = pixel_at(render(scene, options), place_of({0.2, 0.3, 0}, scene, options));
  EXPECT_GT(front.red, front.blue + 40);
  EXPECT_GT(back.blue, back.red + 40);
}

TEST(Show, AFilmShrunkToAPointIsNoAccident) {
  scene::Scene scene = scenes::sphere(2);
  for (Vec3& p : scene.film.edit_positions()) p = {3, 4, 5};
  const Image image = render(scene, small());
  EXPECT_EQ(image.pixels.size(), 160U * 120U);
}

TEST(Show, FilmsAreDenserAtGrazingAngles) {
  PictureOptions options = small();
  options.transparent = true;
  options.style.film.highlights = 0;
  const scene::Scene scene = scenes::sphere(16);
  const Image image = render(scene, options);
  const Place middle = place_of({0, 0, 0}, scene, options);
  const int centre = image.at(middle.x, middle.y).opacity;
  const int rim = image.at(middle.x + 48, middle.y).opacity;
  EXPECT_GT(centre, 30);
  EXPECT_LT(centre, 100);
  EXPECT_GT(rim, centre + 50);
}

// With films that neither shine nor hide, what remains are the lines, in their colours.
TEST(Show, BordersAndWiresAreWhereTheyAreProjected) {
  PictureOptions options = small();
  options.style = plain_style(0.0, 1.0F);
  options.style.background_top = options.style.background_bottom = {1, 1, 1};
  options.style.border = {{1, 0, 0}, 0.03, 0};
  options.style.wire = {{0, 0, 1}, 0.03, 0};
  const scene::Scene scene = scenes::wire_cube(4);
  const Image image = render(scene, options);
  const auto at = [&](const Vec3& p) { return pixel_at(image, place_of(p, scene, options)); };
  for (const Vec3& wire : {Vec3{1, -1, 0.3}, Vec3{0.5, -1, 1}, Vec3{-1, -1, -0.4}, Vec3{0.4, 1, 1}}) {
    EXPECT_GT(at(wire).blue, 100) << wire.x << wire.y << wire.z;
    EXPECT_LT(at(wire).red, 30);
  }
  for (const Vec3& border : {Vec3{0.57, 0.57, 0.5}, Vec3{-0.57, -0.57, -0.5}, Vec3{0, -0.14, 0}}) {
    EXPECT_GT(at(border).red, 100) << border.x << border.y << border.z;
    EXPECT_LT(at(border).blue, 30);
  }
  EXPECT_EQ(distance(at({0.2, -0.57, 0.5}), {255, 255, 255, 255}), 0);  // a film, seen through
}

TEST(Show, ANearerTubeHidesAFilm) {
  PictureOptions options = small();
  options.style = plain_style(1.0, 1.0F);
  options.style.wire = {{0, 0, 0}, 0.05, 0};
  options.view = from_above();
  scenes::Builder b;
  b.patch({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, 1);
  b.edge(b.vertex({-0.5, 0.3, 0.2}), b.vertex({0.5, 0.3, 0.2}));      // before the film
  b.edge(b.vertex({-0.5, -0.3, -0.2}), b.vertex({0.5, -0.3, -0.2}));  // behind it
  const scene::Scene scene = b.finish();
  const Image image = render(scene, options);
  EXPECT_LT(pixel_at(image, place_of({0, 0.3, 0.2}, scene, options)).green, 20);
  EXPECT_GT(pixel_at(image, place_of({0, -0.3, -0.2}, scene, options)).green, 250);
}

TEST(Show, WithoutBackground) {
  PictureOptions options = small();
  options.transparent = true;
  const scene::Scene scene = scenes::wire_cube(4);
  const Image image = render(scene, options);
  EXPECT_EQ(image.at(0, 0).opacity, 0);
  EXPECT_EQ(pixel_at(image, place_of({1, -1, 0.3}, scene, options)).opacity, 255);
  const int film = pixel_at(image, place_of({0.1, -0.8, 0.8}, scene, options)).opacity;
  EXPECT_GT(film, 10);
  EXPECT_LT(film, 250);
}

TEST(Show, WiresAloneAreDrawn) {
  scenes::Builder b;
  b.edge(b.vertex({0, 0, 0}), b.vertex({1, 1, 1}));
  const Image image = render(b.finish(), small());
  std::set<int> greens;
  for (const Pixel& p : image.pixels) greens.insert(p.green);
  EXPECT_LT(*greens.begin(), 120);
}

TEST(Show, TheSamePictureTwice) {
  const scene::Scene scene = scenes::lattice(3, 2);
  EXPECT_EQ(render(scene, small()).pixels, render(scene, small()).pixels);
}

TEST(Show, TilesLeaveNoSeams) {
  PictureOptions options = small();
  options.width = 1300;  // more than one tile
  options.height = 40;
  options.samples = 1;
  options.style = plain_style(0.4, 0.1F);
  options.view = from_above();
  scenes::Builder b;
  b.patch({-40, -1, 0}, {40, -1, 0}, {40, 1, 0}, {-40, 1, 0}, 1);
  const Image image = render(b.finish(), options);
  for (int x = 120; x < 1180; ++x) EXPECT_EQ(image.at(x, 20), image.at(120, 20)) << x;
  EXPECT_NE(image.at(120, 20), image.at(1, 20));
}

TEST(Show, SizesAreWhatWasAskedFor) {
  PictureOptions options = small();
  options.samples = 1;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 70), std::pair(129, 2)}) {
    options.width = width;
    options.height = height;
    const Image image = render(scenes::square_film(1), options);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(width * height));
  }
}

class ShowFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("lamella-show-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path() const { return folder_ / "picture.png"; }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }

  std::filesystem::path folder_;
};

TEST_F(ShowFile, WritesThePicture) {
  const scene::Scene scene = scenes::double_bubble(4, 0.7);
  show_file(scene, path(), small());
  EXPECT_EQ(decode_png(text::read_whole_file(path())).image.pixels, render(scene, small()).pixels);
  EXPECT_EQ(files(), 1U);
}

TEST_F(ShowFile, RefusesBadSizes) {
  for (const auto& [width, height] :
       {std::pair(0, 10), std::pair(10, -1), std::pair(16385, 10), std::pair(10, 100000)}) {
    PictureOptions options = small();
    options.width = width;
    options.height = height;
    try {
      show_file(scenes::square_film(1), path(), options);
      FAIL() << width << " by " << height;
    } catch (const text::Error& error) {
      EXPECT_NE(error.diagnostics().at(0).hint.find("16384"), std::string::npos);
    }
  }
  EXPECT_EQ(files(), 0U);
}

TEST_F(ShowFile, RefusesASceneWithNothingToDraw) {
  text::write_whole_file(path(), "as it was");
  scene::Scene scene;
  scene.film.add_vertex({1, 2, 3});
  EXPECT_THROW(show_file(scene, path(), small()), text::Error);
  EXPECT_THROW(show_file(scene::Scene{}, path(), small()), text::Error);
  EXPECT_EQ(text::read_whole_file(path()), "as it was");
  EXPECT_EQ(files(), 1U);
}

TEST_F(ShowFile, NamesAPathThatCannotBeWritten) {
  const std::string nowhere = folder_ / "no" / "such" / "folder.png";
  try {
    show_file(scenes::square_film(1), nowhere, small());
    FAIL();
  } catch (const text::Error& error) {
    EXPECT_NE(std::string(error.what()).find(nowhere), std::string::npos);
  }
  EXPECT_EQ(files(), 0U);
}

}  // namespace
}  // namespace lamella::picture
