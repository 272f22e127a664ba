#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "energy/film_energy.h"
#include "energy/measure.h"
#include "scene/constraint_sets.h"
#include "scene/projection.h"
#include "solve/descent.h"
#include "solve/lbfgs.h"
#include "solve/newton.h"
#include "support/differences.h"
#include "support/formulas.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella::solve {
namespace {

using film::ElementKind;
using scene::Scene;

std::vector<Vec3> positions_of(const Scene& scene) {
  return {scene.film.positions().begin(), scene.film.positions().end()};
}

// The upper half of a cube's surface as body 1, its rim on the plane z = 0 (constraint 1): a drop on a table.
Scene drop(int refinements) {
  test::Builder b;
  std::vector<film::Vertex> v;
  for (int i = 0; i < 8; ++i)
    v.push_back(b.vertex({double(i & 1), double((i >> 1) & 1), double((i >> 2) & 1)}));
  const int faces[5][4] = {{4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    Vec3 centre;
    for (const int i : f) centre += 0.25 * b.film.position(v[std::size_t(i)]);
    const film::Vertex c = b.vertex(centre);
    for (int k = 0; k < 4; ++k) {
      b.triangle(v[std::size_t(f[k])], v[std::size_t(f[(k + 1) % 4])], c, {film::Region{0}, film::Region{1}});
    }
  }
  Scene scene;
  scene.film = std::move(b.film);
  scene.bodies.push_back(test::body_with_volume(1));
  scene.level_sets[1] = test::level_set("z = 0");
  for (std::uint32_t i = 0; i < scene.film.vertex_rows(); ++i) {
    if (scene.film.position(film::Vertex(i)).z == 0) scene::add_constraint(scene, ElementKind::vertex, i, 1);
  }
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    if (scene.film.valence(film::Edge(i)) == 1) scene::add_constraint(scene, ElementKind::edge, i, 1);
  }
  for (int i = 0; i < refinements; ++i) {
    const std::uint32_t old = scene.film.vertex_rows();
    surgery::refine(scene.film);
    scene::settle_vertices(scene, old);
  }
  return scene;
}

// A cylinder film between two circles of radius cosh(.55) at z = -.55 and .55, its rims riding on them.
Scene catenoid(int refinements) {
  const int around = 12;
  test::Builder b;
  const double radius = std::cosh(0.55);
  Scene scene;
  for (const int ring : {1, 2}) {
    scene::Boundary boundary;
    const std::string r = std::to_string(radius * 1e0);
    language::Variables none;
    boundary.position = {test::formula("cosh(0.55)*cos(p1)", language::FormulaKind::parameter),
                         test::formula("cosh(0.55)*sin(p1)", language::FormulaKind::parameter),
                         test::formula(ring == 1 ? "0.55" : "-0.55", language::FormulaKind::parameter)};
    scene.boundaries[ring] = boundary;
  }
  std::vector<film::Vertex> top;
  std::vector<film::Vertex> bottom;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * M_PI * i / around;
    top.push_back(b.vertex({radius * std::cos(a), radius * std::sin(a), 0.55}));
    bottom.push_back(b.vertex({radius * std::cos(a), radius * std::sin(a), -0.55}));
  }
  for (int i = 0; i < around; ++i) {
    const auto k = std::size_t(i);
    const auto n = std::size_t((i + 1) % around);
    b.triangle(bottom[k], bottom[n], top[n]);
    b.triangle(bottom[k], top[n], top[k]);
  }
  std::vector<std::pair<film::Edge, int>> rims;
  for (int i = 0; i < around; ++i) {
    const auto k = std::size_t(i);
    const auto n = std::size_t((i + 1) % around);
    rims.emplace_back(b.edge(top[k], top[n]).edge(), 1);
    rims.emplace_back(b.edge(bottom[k], bottom[n]).edge(), 2);
  }
  scene.film = std::move(b.film);
  film::Columns& vertices = scene.film.columns(ElementKind::vertex);
  vertices.add(film::flag_column("fixed", film::Inheritance::New::parent));
  scene.film.columns(ElementKind::edge).add(film::flag_column("fixed", film::Inheritance::New::parent));
  for (const auto& [edge, ring] : rims) {
    scene::set_boundary(scene, ElementKind::edge, edge.index, ring);
    scene.film.columns(ElementKind::edge).edit("fixed")->set(edge.index, 0, 1);
  }
  for (int i = 0; i < around; ++i) {
    for (const int ring : {1, 2}) {
      const film::Vertex v = ring == 1 ? top[std::size_t(i)] : bottom[std::size_t(i)];
      scene::set_boundary(scene, ElementKind::vertex, v.index, ring);
      scene::set_boundary_parameters(scene, v, {2 * M_PI * i / around, 0, 0});
      scene.film.columns(ElementKind::vertex).edit("fixed")->set(v.index, 0, 1);
    }
  }
  for (int i = 0; i < refinements; ++i) {
    const std::uint32_t old = scene.film.vertex_rows();
    surgery::refine(scene.film);
    scene::settle_vertices(scene, old);
  }
  return scene;
}

TEST(Constraints, NewVerticesLieOnTheirBoundary) {
  const Scene scene = catenoid(3);
  int on_ring = 0;
  for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
    if (scene::boundary_of(scene, ElementKind::vertex, v) == 0) continue;
    ++on_ring;
    const Vec3& p = scene.film.position(film::Vertex(v));
    EXPECT_NEAR(std::hypot(p.x, p.y), std::cosh(0.55), 1e-14);
    EXPECT_EQ(std::abs(p.z), 0.55);
  }
  EXPECT_EQ(on_ring, 2 * 12 * 8);
}

TEST(Constraints, ProjectionMeetsTwoLevelSetsAtOnce) {
  Scene scene;
  scene.level_sets[1] = test::level_set("x^2 + y^2 + z^2 = 4");
  scene.level_sets[2] = test::level_set("z = 0.3*x + 1");
  for (int i = 0; i < 20; ++i) {
    Vec3 p{std::sin(1.0 * i) + 0.2, std::cos(2.0 * i), 0.4 + 0.1 * i};
    ASSERT_TRUE(scene::project_to_level_sets(scene, std::array{1, 2}, 0, p));
    EXPECT_NEAR(squared_length(p), 4, 4e-15);
    EXPECT_NEAR(p.z, 0.3 * p.x + 1, 1e-15);
  }
  scene.level_sets[3] = test::level_set("z = 5");
  Vec3 p{1, 1, 1};
  EXPECT_FALSE(scene::project_to_level_sets(scene, std::array{1, 3}, 0, p));
}

TEST(Constraints, OneSidedConstraintsHoldOnlyWhereViolated) {
  Scene scene;
  scene.level_sets[1] = test::level_set("z");
  scene.level_sets[1].sense = scene::Sense::nonnegative;
  Vec3 above{1, 2, 3};
  ASSERT_TRUE(scene::project_to_level_sets(scene, std::array{1}, 0, above));
  EXPECT_EQ(above, (Vec3{1, 2, 3}));
  Vec3 below{1, 2, -3};
  ASSERT_TRUE(scene::project_to_level_sets(scene, std::array{1}, 0, below));
  EXPECT_EQ(below, (Vec3{1, 2, 0}));
}

// Energies, contents and gaps of constraints, by differences.
TEST(Constraints, GradientsAgreeWithDifferences) {
  Scene scene = drop(1);
  test::jitter(scene.film, 3, 0.05);
  scene.level_sets[1] = test::level_set("x^2 + 2*y^2 + 3*z^2 + x*y*z = 1");
  scene.level_sets[1].convex = true;
  scene.level_sets[1].energy = test::field("y*z + x^3", "sin(x)*z", "x*y");
  scene.level_sets[1].content = test::field("-y/2 + z^2*x", "x*y^2", "exp(x)*y");
  energy::FilmEnergy energy(scene);
  const std::vector<Vec3> x = positions_of(scene);
  energy.gradient(x);
  std::vector<Vec3> g;
  for (const energy::VertexLine& line : energy.lines()) g.push_back(line.gradient);
  const auto d = test::gradient_by_differences(
      x, [&](const std::vector<Vec3>& y) { return energy.value(y); }, 2e-4);
  for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT(length(g[v] - d[v]), 1e-7) << "vertex " << v;

  energy.gradient(x);
  std::vector<Vec3> volume(x.size());
  energy.volume_gradient().for_each(
      [&](std::uint32_t v, int, const Vec3& gradient) { volume[v] += gradient; });
  energy::FilmEnergy other(scene);
  const auto dv = test::gradient_by_differences(x, [&](const std::vector<Vec3>& y) {
    other.value(y);
    return other.volumes()[1];
  });
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Vec3 wanted = energy.constraints().restricted(static_cast<std::uint32_t>(v), dv[v]);
    EXPECT_LT(length(volume[v] - wanted), 1e-9) << "vertex " << v;
  }
  EXPECT_NEAR(energy::measure(scene).energy, energy.value(x), 1e-12);
  EXPECT_NEAR(energy::measure(scene).volumes[1], energy.volumes()[1], 1e-12);
}

// Second differences of the Lagrangian along motions that are projected back onto the constraints.
void expect_second_variation(const Scene& scene, MotionKind motion) {
  Problem problem(scene);
  std::vector<Vec3> x = positions_of(scene);
  ASSERT_TRUE(problem.constrain(x));
  NewtonSystem system(problem, scene.film, motion);
  bool ok = false;
  system.linearise(x, ok);
  ASSERT_TRUE(ok);
  const std::size_t size = system.basis().size();
  for (unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<double> way(size);
    for (double& w : way) w = u(random);
    for (std::size_t i = 0; i < size; ++i) {
      if (system.basis().direction(i) == Vec3{}) way[i] = 0;
    }
    std::vector<double> image(size);
    system.hessian().multiply(way, image);
    double exact = 0;
    double slope = 0;
    for (std::size_t i = 0; i < size; ++i) {
      exact += way[i] * image[i];
      slope -= way[i] * system.force()[i];
    }
    std::vector<Vec3> field(x.size());
    system.basis().expand(way, field);
    const double h = 3e-4;
    const auto merit = [&](double t) {
      std::vector<Vec3> moved = x;
      for (std::size_t v = 0; v < x.size(); ++v) moved[v] += t * field[v];
      EXPECT_TRUE(problem.constrain(moved));
      return problem.merit(moved);
    };
    const double middle = merit(0);
    const double first = (8 * (merit(h) - merit(-h)) - (merit(2 * h) - merit(-2 * h))) / (12 * h);
    const double second =
        (16 * (merit(h) + merit(-h)) - merit(2 * h) - merit(-2 * h) - 30 * middle) / (12 * h * h);
    EXPECT_NEAR(slope, first, 1e-8 * (1 + std::abs(first)));
    EXPECT_NEAR(exact, second, 2e-6 * std::abs(second));
  }
}

TEST(Constraints, HessiansAgreeWithDifferences) {
  for (const MotionKind motion : {MotionKind::full, MotionKind::normal}) {
    Scene scene = drop(1);
    test::jitter(scene.film, 3, 0.03);
    scene.level_sets[1] = test::level_set("(x-0.5)^2 + 2*(y-0.5)^2 + 0.7*z^2 + 0.2*x*y*z = 0.8");
    scene.level_sets[1].energy = test::field("y*z + x^3", "sin(x)*z", "x*y");
    scene.level_sets[1].content = test::field("-y/2 + z^2*x", "x*y^2", "exp(x)*y");
    expect_second_variation(scene, motion);
    scene.level_sets[1].convex = true;
    expect_second_variation(scene, motion);
    // Two at once leave a curve; another is touched from one side and pushed against.
    scene.level_sets[2] = test::level_set("z = 0.1*x");
    for (std::uint32_t v = 0; v < scene.film.vertex_rows(); v += 3)
      scene::add_constraint(scene, ElementKind::vertex, v, 2);
    expect_second_variation(scene, motion);
    Scene rings = catenoid(1);
    test::jitter(rings.film, 4, 0.02);
    rings.film.columns(ElementKind::vertex).remove("fixed");
    expect_second_variation(rings, motion);
  }
}

// A drop that wets the table at 90 degrees is half a sphere: A = 2 pi r^2 with 2/3 pi r^3 = 1.
TEST(Constraints, ADropBecomesHalfASphere) {
  const double exact = 2 * M_PI * std::pow(1.5 / M_PI, 2.0 / 3);
  double last = 0;
  for (int level = 2; level <= 4; ++level) {
    Scene scene = drop(level);
    scene::Monitor monitor;
    Problem problem(scene);
    LbfgsOptions options;
    options.motion = MotionKind::full;
    options.tolerance = 1e-9;
    const LbfgsReport report = lbfgs(problem, scene, scene.film.edit_positions(), options, monitor);
    EXPECT_EQ(report.ending, Ending::converged);
    for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
      if (scene::on_constraint(scene, ElementKind::vertex, v, 1)) {
        EXPECT_LT(std::abs(scene.film.position(film::Vertex(v)).z), 1e-15);
      }
    }
    const double error = report.energy / exact - 1;
    EXPECT_GT(error, 0);
    if (level > 2) {
      EXPECT_NEAR(last / error, 4, 0.7);
    }
    last = error;
  }
}

TEST(Constraints, NewtonSettlesADropOnATable) {
  Scene scene = drop(3);
  scene::Monitor monitor;
  Problem problem(scene);
  const std::span<Vec3> x = scene.film.edit_positions();
  LbfgsOptions options;
  options.tolerance = 1e-5;
  lbfgs(problem, scene, x, options, monitor);
  Newton method(problem, scene.film, MotionKind::normal);
  NewtonOptions exact;
  exact.tolerance = 1e-18;
  const NewtonReport report = newton(method, x, exact, monitor);
  EXPECT_EQ(report.ending, Ending::converged);
  EXPECT_LE(report.steps, 6);
  EXPECT_EQ(report.stability.negative_modes, 0);  // sliding about the table is no mode of the drop
  EXPECT_LT(problem.energy().constraints().violation(x), 1e-14);
}

// Young's law: a wall energy of -cos(60 degrees) a unit of wetted area, as an integral around the rim, gives
// a cap that meets the table at 60 degrees.
TEST(Constraints, WallEnergySetsTheContactAngle) {
  Scene scene = drop(4);
  // -0.5 * area = -0.5 * integral of x dy around the wetted disc; the rim's edges run either way, so signs
  // are set by side.
  scene.level_sets[1].energy = test::field("0", "-0.5*x", "0");
  film::Column* const column = scene.film.columns(ElementKind::edge).edit(scene::constraint_column);
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
    if (column->value(e) == 0) continue;
    column->set(e, 0, scene.film.edge_of(scene.film.first_side(film::Edge(e))).reversed() ? -1 : 1);
  }
  scene::Monitor monitor;
  Problem problem(scene);
  LbfgsOptions options;
  options.motion = MotionKind::full;
  options.tolerance = 1e-9;
  const LbfgsReport report = lbfgs(problem, scene, scene.film.edit_positions(), options, monitor);
  EXPECT_EQ(report.ending, Ending::converged);
  // Cap of contact angle 60 degrees: V = pi r^3 (2 - 3c + c^3)/3 with c = cos 60, height r(1 - c).
  const double c = 0.5;
  const double r = std::cbrt(3 / (M_PI * (2 - 3 * c + c * c * c)));
  double height = 0;
  for (const Vec3& p : scene.film.positions()) height = std::max(height, p.z);
  EXPECT_NEAR(height / (r * (1 - c)), 1, 5e-3);
}

TEST(Constraints, CatenoidOnExactRingsConvergesAtSecondOrder) {
  const double exact = 7.65181219888;
  double last = 0;
  for (int level = 2; level <= 4; ++level) {
    Scene scene = catenoid(level);
    scene::Monitor monitor;
    Problem problem(scene);
    LbfgsOptions options;
    options.tolerance = 1e-10;
    const LbfgsReport report = lbfgs(problem, scene, scene.film.edit_positions(), options, monitor);
    EXPECT_EQ(report.ending, Ending::converged);
    const double error = std::abs(report.energy / exact - 1);
    if (level > 2) {
      EXPECT_NEAR(last / error, 4, 0.6);
    }
    last = error;
  }
  EXPECT_LT(last, 1e-3);
}

TEST(Constraints, DescentSlidesAlongTheTable) {
  Scene scene = drop(2);
  Problem problem(scene);
  Descent descent(problem);
  double scale = 0;
  double last = HUGE_VAL;
  for (int i = 0; i < 20; ++i) {
    const DescentStep step = descent.step(scene.film.edit_positions(), scale, false, HUGE_VAL);
    ASSERT_EQ(step.ending, Ending::step_limit);
    EXPECT_LT(step.energy, last + 1e-3);
    last = step.energy;
    EXPECT_LT(problem.volume_error(), 1e-4);
  }
  EXPECT_LT(problem.energy().constraints().violation(scene.film.positions()), 1e-14);
}

}  // namespace
}  // namespace lamella::solve
