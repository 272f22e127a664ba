#include "surgery/contract.h"

#include <gtest/gtest.h>

#include "energy/measure.h"
#include "film/check.h"
#include "film/intersections.h"
#include "surgery/link.h"
#include "surgery/nets.h"

namespace lamella::surgery {
namespace {

using film::Film;
using film::Vertex;
using test::Cone;

void expect_sound(const Film& film) {
  const auto found = check(film);
  ASSERT_TRUE(found.empty()) << found[0];
  // On the fixed outline of a cone films end, and regions with them.
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    const auto fixed = film.columns(film::ElementKind::edge).flags("fixed");
    if (!film.alive(e) || (!fixed.empty() && fixed[i] != 0)) continue;
    film.for_each_side(
        e, [&](film::Side s) { EXPECT_EQ(film.region_after(s), film.region_before(film.next_around(s))); });
  }
  EXPECT_TRUE(film::self_intersections(film).empty());
}

TEST(Link, CountsSectorsOfCones) {
  struct Case {
    test::Net net;
    int sectors;
    LinkKind kind;
  };
  const Case cases[] = {{test::tetrahedron_net(), 4, LinkKind::tetrahedral},
                        {test::cube_net(), 6, LinkKind::illegal},
                        {test::prism_net(3, 0.5), 5, LinkKind::illegal},
                        {test::octahedron_net(), 8, LinkKind::illegal}};
  for (const Case& each : cases) {
    for (const bool regions : {true, false}) {
      const Cone cone = test::cone_over(each.net, regions);
      expect_sound(cone.scene.film);
      const Link link = link_of(cone.scene.film, cone.centre);
      EXPECT_TRUE(link.sound);
      EXPECT_EQ(link.components, 1);
      EXPECT_EQ(static_cast<int>(link.sectors.size()), each.sectors);
      EXPECT_EQ(kind_of(link), each.kind);
    }
  }
}

// Every vertex of a foam of random cubes has as many sectors as Euler's formula says.
TEST(Link, EulerHoldsInRandomFoams) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const scene::Scene scene = test::random_foam(seed);
    for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
      const Link link = link_of(scene.film, Vertex(v));
      ASSERT_TRUE(link.sound);
      EXPECT_EQ(link.sectors.size() + link.nodes.size(),
                link.arcs.size() + 2 * static_cast<std::size_t>(link.components));
    }
  }
}

void expect_resolved(const test::Net& net, double least_gain, const char* name) {
  for (const bool regions : {true, false}) {
    Cone cone = test::cone_over(net, regions);
    const double before = energy::measure(cone.scene).area;
    const auto done = contract(cone.scene, std::span(&cone.centre, 1), {.size = 1, .gain = 1e-5});
    ASSERT_TRUE(done) << name;
    expect_sound(cone.scene.film);
    EXPECT_GT(done->gain, least_gain) << name;
    cone.scene.film.compact();
    EXPECT_NEAR(energy::measure(cone.scene).area, before - done->gain, 1e-9) << name;
  }
}

TEST(Contract, ResolvesConesThatNoFilmKeeps) {
  expect_resolved(test::cube_net(), 2e-4, "cube");
  expect_resolved(test::cube_net(0.8), 0.05, "flat cube");
  expect_resolved(test::prism_net(3, 0.8), 0.2, "tall prism");
  expect_resolved(test::prism_net(3, 0.3), 0.1, "flat prism");
  expect_resolved(test::prism_net(5, 0.5), 0.01, "pentagonal prism");
  expect_resolved(test::octahedron_net(), 0.1, "octahedron");
}

TEST(Contract, LeavesLegalPoints) {
  Cone cone = test::cone_over(test::tetrahedron_net());
  const auto revision = cone.scene.film.connectivity_revision();
  EXPECT_FALSE(contract(cone.scene, std::span(&cone.centre, 1), {.size = 1}));
  EXPECT_EQ(cone.scene.film.connectivity_revision(), revision);
}

// A tall prism's cone parts into an upright border, a flat one's opens a face.
TEST(Contract, TheShapeDecidesHowNeighboursSwap) {
  Cone tall = test::cone_over(test::prism_net(3, 0.8));
  ASSERT_TRUE(contract(tall.scene, std::span(&tall.centre, 1), {.size = 1}));
  EXPECT_EQ(tall.scene.film.vertex_count(), 6U + 2U);
  Cone flat = test::cone_over(test::prism_net(3, 0.25));
  ASSERT_TRUE(contract(flat.scene, std::span(&flat.centre, 1), {.size = 1}));
  EXPECT_EQ(flat.scene.film.vertex_count(), 6U + 3U);
}

// Two sheets that share a point come apart.
TEST(Contract, SeparatesWhatMeetsInAPoint) {
  test::Builder b;
  const Vertex tip = b.vertex({0, 0, 0});
  for (const double z : {-0.3, 0.3}) {
    std::vector<Vertex> ring;
    for (int i = 0; i < 6; ++i) ring.push_back(b.vertex({std::cos(M_PI * i / 3), std::sin(M_PI * i / 3), z}));
    for (std::size_t i = 0; i < 6; ++i) b.triangle(tip, ring[i], ring[(i + 1) % 6]);
  }
  scene::Scene scene;
  scene.film = std::move(b.film);
  EXPECT_EQ(link_of(scene.film, tip).components, 2);
  const auto done = contract(scene, std::span(&tip, 1), {.size = 1});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->event.kind, EventKind::pinch);
  EXPECT_EQ(done->made.size(), 2U);
  expect_sound(scene.film);
}

}  // namespace
}  // namespace lamella::surgery
