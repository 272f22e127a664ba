// What is saved is loaded back the same, bit for bit; and Evolver loads it too.
#include <optional>

#include <gtest/gtest.h>

#include "datafile/evolver.h"
#include "datafile/expectation.h"
#include "datafile/measures.h"
#include "datafile/read.h"
#include "datafile/same_scene.h"
#include "datafile/write.h"
#include "energy/measure.h"
#include "support/evolver.h"

namespace lamella::test {

namespace {

// Nothing where the file is refused.
std::optional<datafile::ReadResult> load(const std::string& path) {
  try {
    return datafile::read_datafile(path);
  } catch (const text::Error&) {
    return std::nullopt;
  }
}

scene::Scene load_text(const std::string& content) {
  return datafile::read_datafile(text::make_source("saved.fe", content)).scene;
}

std::vector<std::string> all_datafiles() {
  std::vector<std::string> result = datafiles_in("datafiles");
  for (const char* folder : {"datafiles/tricky", "datafiles/broken"}) {
    for (std::string& file : datafiles_in(folder)) result.push_back(std::move(file));
  }
  return result;
}

TEST(RoundTrip, GivesTheSameScene) {
  for (const std::string& path : all_datafiles()) {
    SCOPED_TRACE(path);
    const auto loaded = load(path);
    if (!loaded) continue;  // a broken file
    const std::string saved = datafile::write_datafile(loaded->scene);
    const scene::Scene again = load_text(saved);
    EXPECT_EQ(first_difference(loaded->scene, again), "");
    EXPECT_EQ(datafile::write_datafile(again), saved);
  }
}

// Whether the time stands anywhere but where it is set.
bool reads_time(const std::string& saved) {
  for (std::size_t at = saved.find("total_time"); at != std::string::npos;
       at = saved.find("total_time", at + 1)) {
    if (at > 0 && saved[at - 1] != '\n') return true;
  }
  return false;
}

TEST(RoundTrip, IsReadByEvolver) {
  if (!trial::evolver_is_installed()) GTEST_SKIP() << "Surface Evolver is not installed";
  for (const std::string& path : all_datafiles()) {
    SCOPED_TRACE(path);
    const auto loaded = load(path);
    if (!loaded) continue;
    scene::Scene scene = loaded->scene;
    const bool formulas = !scene.level_sets.empty() || !scene.boundaries.empty() ||
                          !scene.quantities.empty() || !scene.periods.empty();
    if (!formulas) scene.variables = {};  // Evolver has no parameters of a single letter
    const std::string saved = datafile::write_datafile(scene);
    if (formulas && reads_time(saved)) continue;  // Evolver's formulas cannot
    const EvolverAnswer answer = ask_evolver(saved);
    EXPECT_TRUE(answer.loaded) << answer.output;
    EXPECT_EQ(answer.vertices, scene.film.vertex_count());
    EXPECT_EQ(answer.edges, scene.film.edge_count());
    EXPECT_EQ(answer.facets, facet_count(scene));
    EXPECT_EQ(answer.bodies, body_count(scene));
    if (!scene.strings.on) {
      EXPECT_NEAR(answer.area, area(scene), 1e-12 * area(scene));
    }
    const double energy = energy::measure(scene).energy;
    EXPECT_NEAR(answer.energy, energy, 1e-12 * std::abs(energy));
  }
}

// --- a scene with everything in it

constexpr const char* two_tetrahedra = R"(// Two tetrahedra
// that share a face

define vertex attribute heat real
define edge attribute grade integer[2]
define facet attribute table real[2][2]
define body attribute price real

vertices
1  0 0 0  heat 0.1 fixed
2  1 0 0
3  0 1 0  bare
4  0 0 1
5  0 0 -1

edges
1  1 2  fixed tension 0.3
2  2 3  color red bare
3  3 1  no_refine
4  1 4  grade {1,-2}
5  2 4
6  3 4
7  1 5
8  2 5
9  3 5

faces
1  -3 -2 -1  tension 1/3 frontcolor red
2  1 5 -4    color blue opacity 0.5
3  2 6 -5    fixed no_refine nodisplay
4  3 4 -6    table {{1,2},{3,1/7}}
5  7 -8 -1
6  8 -9 -2
7  9 -7 -3

bodies
1  1 2 3 4  volume 1/6 density 2 price 9.99
2  -1 5 6 7 pressure 0.25 volconst 1e-3
)";

scene::Scene rich_scene() {
  scene::Scene scene = load_text(two_tetrahedra);
  scene.film.columns(film::ElementKind::vertex)
      .add(film::real_column("velocity", 0, 3, film::Inheritance::New::mean));
  scene.film.columns(film::ElementKind::vertex).add(film::real_column("mass"));
  film::Column& velocity = *scene.film.columns(film::ElementKind::vertex).edit("velocity");
  film::Column& mass = *scene.film.columns(film::ElementKind::vertex).edit("mass");
  for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis) velocity.set(v, axis, (v - 2.0) / (axis + 3.0));
    mass.set(v, 0, 1 / (v + 3.0));
  }
  velocity.set(0, 1, -0.0);
  velocity.set(0, 2, 5e-324);
  scene.gravity = {9.81 / 3, false};
  scene.scale = {1.0 / 3, true, 0.7};
  scene.keep_volumes = false;
  scene.symmetric_content = true;
  scene.time = 0.1 + 0.2;
  scene.damping = 2.0 / 3;
  scene.cosmetics = {{"evolver_version", "\"2.10\""},
                     {"view_matrix", "\n1 0 0 -1\n0 1 0 0\n0 0 1 0\n0 0 0 1"}};
  scene.bodies[0].pressure = 1.0 / 7;
  scene.bodies[0].ramp = scene::VolumeRamp{1.0 / 6, 0.2, 0.1, 1.0 / 3};
  const auto set = [&](const char* name, language::Value value, bool parameter) {
    const language::VariableId id = scene.variables.id(name);
    scene.variables.set(id, std::move(value));
    if (parameter) scene.variables.mark_parameter(id);
  };
  set("Width", 1.0 / 3, true);
  set("label", std::string("a \"b\"\\c\n\td"), true);
  set("steps", 12.0, false);
  set("words", std::string("said \"no\""), false);
  scene.procedures["gogo"] = {"gogo", "{ half_way; g 5 }", nullptr, {}, false};
  scene.procedures["half_way"] = {"half_way", "{ r; // half\n u }", nullptr, {}, false};
  scene.procedures["third"] = {"third", "{ return a/3 }", nullptr, {"real a"}, true};
  return scene;
}

TEST(RoundTripOfEverything, GivesTheSameScene) {
  const scene::Scene scene = rich_scene();
  EXPECT_EQ(first_difference(scene, load_text(datafile::write_datafile(scene))), "");
}

TEST(RoundTripOfEverything, KeepsVariablesAndProceduresAsCommands) {
  const std::string saved = datafile::write_datafile(rich_scene());
  const auto loaded = datafile::read_datafile(text::make_source("saved.fe", saved));
  ASSERT_EQ(loaded.read_section.size(), 1U);
  const text::Place& place = loaded.read_section[0];
  EXPECT_EQ(place.source->content.substr(place.offset, place.length), R"(

gravity off
steps := 12
words := "said \"no\""
gogo := {}
half_way := {}
function real third(real a);
gogo := { half_way; g 5 }
half_way := { r; // half
 u }
function real third(real a) { return a/3 }
)");
}

TEST(RoundTripOfEverything, IsReadByEvolver) {
  if (!trial::evolver_is_installed()) GTEST_SKIP() << "Surface Evolver is not installed";
  scene::Scene scene = rich_scene();
  scene.procedures.erase("third");  // its parameter has a single letter
  scene.procedures["third"] = {"third", "{ return aa/3 }", nullptr, {"real aa"}, true};
  const EvolverAnswer answer = ask_evolver(datafile::write_datafile(scene));
  ASSERT_TRUE(answer.loaded) << answer.output;
  EXPECT_EQ(answer.facets, scene.film.triangle_count());
  EXPECT_NEAR(answer.area, area(scene), 1e-12 * area(scene));
}

TEST(RoundTripOfRemovedElements, KeepsTheNumbersOfTheOthers) {
  scene::Scene scene = rich_scene();
  film::Film& film = scene.film;
  film.remove(film::Triangle(4U));
  film.remove(film::Triangle(5U));
  film.remove(film::Triangle(6U));
  film.set_regions(film::Triangle(0U), {film::outside_region, {2}});
  for (std::uint32_t t = 1; t < 4; ++t) film.set_regions(film::Triangle(t), {film::outside_region, {2}});
  for (const std::uint32_t e : {6U, 7U, 8U}) film.remove(film::Edge(e));
  film.remove(film::Vertex(4U));
  scene.bodies[1] = scene.bodies[0];
  scene.bodies[0].absent = true;
  film.remove(film::Triangle(2U));
  const scene::Scene again = load_text(datafile::write_datafile(scene));
  EXPECT_EQ(first_difference(scene, again), "");
  EXPECT_EQ(again.film.number(film::Triangle(2U)), 4U);
  EXPECT_EQ(again.bodies.size(), 2U);
  EXPECT_TRUE(again.bodies[0].absent);

  scene.film.compact();
  EXPECT_EQ(first_difference(scene, again), "");
}

TEST(RoundTripOfSparseNumbers, KeepsThemWhereTheDatafileSaysSo) {
  const scene::Scene scene = load_text(
      "keep_originals\nvertices\n70 0 0 0\n3 1 0 0\n2000000000 1 1 0\n1 0 1 0\nedges\n9 70 3\n8 3 "
      "2000000000\n"
      "7 2000000000 1\n1 1 70\nfaces\n5 9 8 7 1\nbodies\n3 5 volume 1\n");
  EXPECT_EQ(scene.film.number(film::Vertex(2U)), 2000000000U);
  EXPECT_EQ(scene.film.number(film::Vertex(4U)), 2U) << "the centre gets the lowest free number";
  EXPECT_EQ(scene.bodies.size(), 3U);
  EXPECT_EQ(body_count(scene), 1U);
  EXPECT_EQ(first_difference(scene, load_text(datafile::write_datafile(scene))), "");
}

TEST(WriteDatafile, RefusesNumbersThatCouldNotBeRead) {
  scene::Scene scene = load_text(two_tetrahedra);
  scene.film.move(film::Vertex(1U), {0, std::nan(""), 0});
  EXPECT_THROW(datafile::write_datafile(scene), text::Error);

  scene = load_text(two_tetrahedra);
  scene.film.columns(film::ElementKind::vertex).edit("heat")->set(2, 0, INFINITY);
  EXPECT_THROW(datafile::write_datafile(scene), text::Error);
}

TEST(WriteDatafile, LeavesOutVariablesThatAreNotFinite) {
  scene::Scene scene = load_text(two_tetrahedra);
  scene.variables.set(scene.variables.id("ratio"), INFINITY);
  EXPECT_NE(datafile::write_datafile(scene).find("// ratio was not a finite number"), std::string::npos);
}

}  // namespace

}  // namespace lamella::test
