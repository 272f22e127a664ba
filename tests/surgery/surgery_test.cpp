#include <gtest/gtest.h>

#include "energy/measure.h"
#include "energy/triangle.h"
#include "film/check.h"
#include "support/shapes.h"
#include "surgery/average.h"
#include "surgery/equiangulate.h"
#include "surgery/flip.h"
#include "surgery/refine.h"
#include "surgery/split_edge.h"

namespace lamella::surgery {
namespace {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

void expect_sound(const Film& film, const char* after) {
  const auto found = check(film);
  ASSERT_TRUE(found.empty()) << "after " << after << ": " << found[0];
  const auto labels = check_regions(film);
  ASSERT_TRUE(labels.empty()) << "after " << after << ": " << labels[0];
}

void expect_same_measures(const Scene& scene, const energy::Measures& before) {
  const energy::Measures after = energy::measure(scene);
  EXPECT_NEAR(after.area, before.area, 1e-12 * before.area);
  for (std::size_t r = 1; r < before.volumes.size(); ++r)
    EXPECT_NEAR(after.volumes[r], before.volumes[r], 1e-12);
}

TEST(Refine, CutsIntoFourAndKeepsAreaVolumeAndLabels) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Scene scene = test::random_foam(seed);
    const energy::Measures before = energy::measure(scene);
    const std::uint32_t v = scene.film.vertex_count();
    const std::uint32_t e = scene.film.edge_count();
    const std::uint32_t t = scene.film.triangle_count();
    const RefineCounts counts = refine(scene.film);
    EXPECT_EQ(counts.edges, e);
    EXPECT_EQ(counts.facets, t);
    EXPECT_EQ(scene.film.vertex_count(), v + e);
    EXPECT_EQ(scene.film.edge_count(), 2 * e + 3 * t);
    EXPECT_EQ(scene.film.triangle_count(), 4 * t);
    expect_sound(scene.film, "refine");
    expect_same_measures(scene, before);
  }
}

// The numbering of the elder program, read off its listing of a refined triangle with edges 1 (1-2), 2 (2-3),
// 3 (3-1).
TEST(Refine, NumbersLikeEvolver) {
  test::Builder b;
  const Vertex p = b.vertex({0, 0, 0});
  const Vertex q = b.vertex({1, 0, 0});
  const Vertex r = b.vertex({0, 1, 0});
  b.triangle(p, q, r);
  refine(b.film);
  const auto ends = [&](std::uint32_t number) {
    const auto& at = b.film.ends(b.film.edge_numbered(number));
    return std::pair(b.film.number(at[0]), b.film.number(at[1]));
  };
  EXPECT_EQ(ends(1), std::pair(1U, 4U));
  EXPECT_EQ(ends(4), std::pair(4U, 2U));
  EXPECT_EQ(ends(7), std::pair(4U, 6U));
  EXPECT_EQ(ends(8), std::pair(5U, 4U));
  EXPECT_EQ(ends(9), std::pair(6U, 5U));
  const auto loop = [&](std::uint32_t number) {
    std::array<int, 3> result{};
    const auto& edges = b.film.edges(b.film.triangle_numbered(number));
    for (std::size_t k = 0; k < 3; ++k) {
      const int n = static_cast<int>(b.film.number(edges[k].edge()));
      result[k] = edges[k].reversed() ? -n : n;
    }
    return result;
  };
  EXPECT_EQ(loop(1), (std::array{-9, -7, -8}));
  EXPECT_EQ(loop(2), (std::array{1, 7, 6}));
  EXPECT_EQ(loop(3), (std::array{4, 2, 8}));
  EXPECT_EQ(loop(4), (std::array{9, 5, 3}));
}

TEST(Refine, LeavesMarkedEdgesWhole) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Scene scene = test::random_foam(seed);
    const energy::Measures before = energy::measure(scene);
    film::Column& whole = scene.film.columns(ElementKind::edge).add(film::flag_column("no_refine"));
    std::uint32_t marked = 0;
    for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
      const bool mark = (e * 7919 + seed) % 3 == 0;
      whole.set(e, 0, mark ? 1 : 0);
      marked += mark ? 1 : 0;
    }
    const std::uint32_t edges = scene.film.edge_count();
    EXPECT_EQ(refine(scene.film).edges, edges - marked);
    expect_sound(scene.film, "refining unmarked edges");
    expect_same_measures(scene, before);
  }
}

TEST(Refine, ColumnsInheritByTheirRules) {
  Scene scene = test::cube();
  Film& film = scene.film;
  film.columns(ElementKind::vertex).add(film::real_column("velocity", 0, 3, film::Inheritance::New::mean));
  film.columns(ElementKind::vertex).add(film::real_column("heat", 0));
  film.columns(ElementKind::vertex).add(film::flag_column("fixed", film::Inheritance::New::parent));
  film.columns(ElementKind::edge).add(film::flag_column("fixed", film::Inheritance::New::parent));
  film.columns(ElementKind::facet).add(film::flag_column("fixed"));
  film.columns(ElementKind::facet).add(film::integer_column("color", 15));
  film.columns(ElementKind::edge).edit("fixed")->set(0, 0, 1);
  film.columns(ElementKind::facet).edit("fixed")->set(5, 0, 1);
  film.columns(ElementKind::facet).edit("color")->set(5, 0, 4);
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    film.columns(ElementKind::vertex).edit("velocity")->set(v, 1, film.position(Vertex(v)).x);
    film.columns(ElementKind::vertex).edit("heat")->set(v, 0, 1);
  }
  const std::uint32_t vertices = film.vertex_rows();
  const std::uint32_t edges = film.edge_rows();
  const std::uint32_t facets = film.triangle_rows();
  refine(film);
  const film::Columns& of_vertices = film.columns(ElementKind::vertex);
  for (std::uint32_t v = vertices; v < film.vertex_rows(); ++v) {
    EXPECT_DOUBLE_EQ(of_vertices.find("velocity")->value(v, 1), film.position(Vertex(v)).x);
    EXPECT_EQ(of_vertices.find("heat")->value(v), 0);
    EXPECT_EQ(of_vertices.find("fixed")->value(v), v == vertices ? 1 : 0);
  }
  EXPECT_EQ(film.columns(ElementKind::edge).find("fixed")->value(0), 1);
  EXPECT_EQ(film.columns(ElementKind::edge).find("fixed")->value(edges), 1);
  int fixed_inner = 0;
  for (std::uint32_t e = 2 * edges; e < film.edge_rows(); ++e) {
    fixed_inner += film.columns(ElementKind::edge).find("fixed")->value(e) != 0 ? 1 : 0;
  }
  EXPECT_EQ(fixed_inner, 3);
  int coloured = 0;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (film.columns(ElementKind::facet).find("color")->value(t) != 4) continue;
    ++coloured;
    EXPECT_EQ(film.columns(ElementKind::facet).find("fixed")->value(t), 1);
  }
  EXPECT_EQ(coloured, 4);
  (void)facets;
}

TEST(SplitEdge, KeepsEverythingOnRandomFoams) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Scene scene = test::random_foam(seed);
    const energy::Measures before = energy::measure(scene);
    const std::uint32_t edges = scene.film.edge_rows();
    for (std::uint32_t e = seed % 3; e < edges; e += 3) {
      const int films = scene.film.valence(Edge(e));
      const std::uint32_t triangles = scene.film.triangle_count();
      const Vertex made = split_edge(scene.film, Edge(e));
      EXPECT_EQ(scene.film.triangle_count(), triangles + static_cast<std::uint32_t>(films));
      EXPECT_EQ(scene.film.valence(made), 2 + films);
      EXPECT_EQ(scene.film.ends(Edge(e))[1], made);
    }
    expect_sound(scene.film, "splitting edges");
    expect_same_measures(scene, before);
  }
}

TEST(SplitEdge, DividesAWire) {
  test::Builder b;
  const Vertex p = b.vertex({0, 0, 0});
  const Vertex q = b.vertex({2, 0, 0});
  const Edge e = b.edge(p, q).edge();
  const Vertex m = split_edge(b.film, e);
  EXPECT_EQ(b.film.position(m), (Vec3{1, 0, 0}));
  EXPECT_EQ(b.film.edge_count(), 2U);
  expect_sound(b.film, "splitting a wire");
}

TEST(Flip, TwiceIsTheSameFilmWithBothOrientations) {
  for (const bool along : {false, true}) {
    test::Builder b;
    const Vertex p = b.vertex({0, 0, 0});
    const Vertex q = b.vertex({1, 0.1, 0});
    const Vertex r = b.vertex({0.4, 1, 0});
    const Vertex w = b.vertex({0.5, -1, 0.1});
    b.triangle(p, q, r, {film::Region{2}, film::Region{1}});
    along ? b.triangle(p, q, w, {film::Region{1}, film::Region{2}})
          : b.triangle(q, p, w, {film::Region{2}, film::Region{1}});
    b.triangle(r, q, b.vertex({2, 2, 0}), {film::Region{2}, film::Region{1}});
    const Edge e = b.edge(p, q).edge();
    auto d = flippable(b.film, e);
    ASSERT_TRUE(d.has_value());
    flip(b.film, *d);
    ASSERT_TRUE(check(b.film).empty()) << check(b.film)[0];
    EXPECT_TRUE(b.film.find_edge(r, w).valid());
    EXPECT_FALSE(b.film.find_edge(p, q).valid());
    for (std::uint32_t t = 0; t < 2; ++t) {
      const auto& c = b.film.corners(Triangle(t));
      EXPECT_GT(
          energy::double_area_vector(b.film.position(c[0]), b.film.position(c[1]), b.film.position(c[2])).z,
          0);
      EXPECT_EQ(b.film.regions(Triangle(t)), (film::RegionPair{film::Region{2}, film::Region{1}}));
    }
    d = flippable(b.film, e);
    ASSERT_TRUE(d.has_value());
    flip(b.film, *d);
    ASSERT_TRUE(check(b.film).empty()) << check(b.film)[0];
    EXPECT_TRUE(b.film.find_edge(p, q).valid());
  }
}

TEST(Flip, NeverAcrossABorderOrRimOrLabel) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Scene scene = test::random_foam(seed);
    for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
      if (scene.film.valence(Edge(e)) != 2) {
        EXPECT_FALSE(flippable(scene.film, Edge(e)).has_value());
      }
    }
  }
  Scene cube = test::cube();
  cube.film.set_regions(Triangle(0U), {film::Region{0}, film::Region{0}});
  for (const film::SignedEdge edge : cube.film.edges(Triangle(0U)))
    EXPECT_FALSE(flippable(cube.film, edge.edge()).has_value());
}

TEST(Equiangulate, MakesAFlatFilmDelaunay) {
  Scene scene = test::square_film(12);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-0.02, 0.02);
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  const std::span<Vec3> p = scene.film.edit_positions();
  for (std::size_t v = 0; v < p.size(); ++v) {
    if (fixed[v] == 0) p[v] += Vec3{shift(random), shift(random), 0};
  }
  // Make it bad first: flip every third edge that can be flipped flat.
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); e += 3) {
    const auto d = flippable(scene.film, Edge(e));
    if (d && flip_is_flat(scene.film, *d)) flip(scene.film, *d);
  }
  int passes = 0;
  while (equiangulate(scene.film) > 0) ASSERT_LT(++passes, 50);
  expect_sound(scene.film, "equiangulation");
  EXPECT_NEAR(energy::measure(scene).area, 1, 1e-12);
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
    const auto d = flippable(scene.film, Edge(e));
    if (d) {
      EXPECT_FALSE(is_worse_diagonal(scene.film, *d));
    }
  }
}

TEST(Average, KeepsFlatFilmsFlatAndFixedVerticesFixed) {
  Scene scene = test::square_film(10);
  const std::vector<Vec3> at(scene.film.positions().begin(), scene.film.positions().end());
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-0.03, 0.03);
  const std::span<Vec3> p = scene.film.edit_positions();
  for (std::size_t v = 0; v < p.size(); ++v) {
    if (fixed[v] == 0) p[v] += Vec3{shift(random), shift(random), 0};
  }
  const auto smallest = [&] {
    double worst = 4;
    for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
      const auto& c = scene.film.corners(Triangle(t));
      worst = std::min(worst, energy::smallest_angle(scene.film.position(c[0]), scene.film.position(c[1]),
                                                     scene.film.position(c[2])));
    }
    return worst;
  };
  const double before = smallest();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(average_vertices(scene.film), 81U);
  EXPECT_GT(smallest(), before + 0.1);
  EXPECT_NEAR(energy::measure(scene).area, 1, 1e-12);
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (fixed[v] != 0) {
      EXPECT_EQ(scene.film.positions()[v], at[v]);
    }
  }
}

// Volumes change to second order only: a tenth of the unevenness, a hundredth of the error.
// A film that has shrunk to a point, or nearly so, must not keep it going for ever.
TEST(Average, EndsOnFilmsWithoutArea) {
  for (const double size : {0.0, 1e-170, 1e-300}) {
    scene::Scene scene = test::cube(size);
    average_vertices(scene.film);
    for (const Vec3& p : scene.film.positions()) EXPECT_LE(length(p), 2 * size);
  }
}

TEST(Average, KeepsVolumesToFirstOrder) {
  const auto error = [](double by) {
    Scene scene = test::cube();
    refine(scene.film);
    refine(scene.film);
    for (Vec3& p : scene.film.edit_positions()) {
      const Vec3 d = p - Vec3{0.5, 0.5, 0.5};
      p = unit(d) + by * Vec3{std::sin(5 * d.y + 1), std::sin(6 * d.z), std::sin(7 * d.x + 2)};
    }
    // Start from an averaged state, so that what remains to move is of the order of `by`.
    const double before = energy::measure(scene).volumes[1];
    average_vertices(scene.film);
    return std::abs(energy::measure(scene).volumes[1] - before);
  };
  EXPECT_LT(error(0.01), 0.01);
}

TEST(Upkeep, RandomSequencesKeepEveryInvariant) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    Scene scene = test::random_foam(seed);
    std::mt19937 random(seed);
    for (int step = 0; step < 4; ++step) {
      switch (random() % 4) {
        case 0:
          refine(scene.film);
          break;
        case 1:
          equiangulate(scene.film);
          break;
        case 2:
          average_vertices(scene.film);
          break;
        default:
          split_edge(scene.film, Edge(static_cast<std::uint32_t>(random() % scene.film.edge_rows())));
      }
      const auto found = check(scene.film);
      ASSERT_TRUE(found.empty()) << "seed " << seed << ", step " << step << ": " << found[0];
      if (scene.film.triangle_count() > 20000) break;
    }
  }
}

}  // namespace
}  // namespace lamella::surgery
