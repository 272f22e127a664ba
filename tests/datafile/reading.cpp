// What a datafile means: cut faces, attributes, macros, included files, settings, what stands after `read`.
#include <filesystem>

#include <gtest/gtest.h>

#include "datafile/measures.h"
#include "datafile/read.h"
#include "text/whole_file.h"

namespace lamella::test {

namespace {

namespace files = std::filesystem;
using film::Edge;
using film::ElementKind;
using film::Triangle;
using film::Vertex;

datafile::ReadResult read(const std::string& content) {
  return datafile::read_datafile(text::make_source("test.fe", content));
}

// The messages of what is refused, one a line.
std::string complaints(const std::string& content) {
  try {
    return text::render(read(content).warnings);
  } catch (const text::Error& error) {
    std::string result;
    for (const text::Diagnostic& diagnostic : error.diagnostics()) result += diagnostic.message + "\n";
    return result;
  }
}

std::string text_of(const text::Place& place) {
  return place.source->content.substr(place.offset, place.length);
}

// Signed numbers of the edges of a facet.
std::vector<int> loop(const film::Film& film, std::uint32_t facet) {
  std::vector<int> result;
  for (const film::SignedEdge e : film.edges(film.triangle_numbered(facet))) {
    const int number = static_cast<int>(film.number(e.edge()));
    result.push_back(e.reversed() ? -number : number);
  }
  return result;
}

std::vector<std::uint32_t> ends(const film::Film& film, std::uint32_t edge) {
  const auto& [tail, head] = film.ends(film.edge_numbered(edge));
  return {film.number(tail), film.number(head)};
}

constexpr const char* triangle =
    "vertices\n1 0 0 0\n2 1 0 0\n3 0 1 0\nedges\n1 1 2\n2 2 3\n3 3 1\nfaces\n1 1 2 3\n";

// --- faces of more than three edges

constexpr const char* two_squares = R"(
define vertex attribute heat real
define vertex attribute velocity real[3]
define facet attribute grade integer
vertices
10  0 0 0  heat 4 velocity {1,0,4}
20  1 0 0
30  1 1 0
40  0 1 2
50  2 0 0
60  2 1 0
edges
1  10 20
2  20 30
3  30 40
4  40 10
5  20 50
6  50 60
7  60 30
faces
8  1 2 3 4   fixed tension 2 color red grade 7
9  5 6 7 -2  no_refine
bodies
5  9 8 density 3
)";

TEST(CutFaces, AreNumberedAsInEvolver) {
  const film::Film film = read(two_squares).scene.film;
  EXPECT_EQ(film.vertex_count(), 8U);
  EXPECT_EQ(film.edge_count(), 15U);
  EXPECT_EQ(film.triangle_count(), 8U);
  EXPECT_EQ(film.position(Vertex(6U)), (film::Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(film.position(Vertex(7U)), (film::Vec3{1.5, 0.5, 0}));
  // From the corners, in the order of the loop, to the centre.
  EXPECT_EQ(ends(film, 8), (std::vector<std::uint32_t>{1, 7}));
  EXPECT_EQ(ends(film, 11), (std::vector<std::uint32_t>{4, 7}));
  EXPECT_EQ(ends(film, 12), (std::vector<std::uint32_t>{2, 8}));
  EXPECT_EQ(ends(film, 15), (std::vector<std::uint32_t>{3, 8}));
  // A face keeps the piece at its last edge.
  EXPECT_EQ(loop(film, 1), (std::vector<int>{-11, 4, 8}));
  EXPECT_EQ(loop(film, 2), (std::vector<int>{-15, -2, 12}));
  EXPECT_EQ(loop(film, 3), (std::vector<int>{1, 9, -8}));
  EXPECT_EQ(loop(film, 5), (std::vector<int>{3, 11, -10}));
  EXPECT_EQ(loop(film, 6), (std::vector<int>{5, 13, -12}));
}

TEST(CutFaces, HandDownWhatTheyHave) {
  const scene::Scene scene = read(two_squares).scene;
  const film::Film& film = scene.film;
  const auto value = [&](ElementKind kind, const char* name, std::uint32_t row) {
    const film::Column* const column = film.columns(kind).find(name);
    return column != nullptr ? column->value(row) : -1000;
  };
  for (const std::uint32_t piece : {0U, 2U, 3U, 4U}) {
    EXPECT_EQ(value(ElementKind::facet, "fixed", piece), 1);
    EXPECT_EQ(value(ElementKind::facet, "tension", piece), 2);
    EXPECT_EQ(value(ElementKind::facet, "color", piece), 4);
    EXPECT_EQ(value(ElementKind::facet, "grade", piece), 7);
    EXPECT_EQ(value(ElementKind::facet, "original", piece), 8);
    EXPECT_EQ(film.regions(Triangle(piece)), (film::RegionPair{{0}, {1}}));
  }
  for (const std::uint32_t piece : {1U, 5U, 6U, 7U}) {
    EXPECT_EQ(value(ElementKind::facet, "fixed", piece), 0);
    EXPECT_EQ(value(ElementKind::facet, "tension", piece), 1);
    EXPECT_EQ(film.regions(Triangle(piece)), (film::RegionPair{{0}, {1}}));
  }
  // What is drawn inside a fixed face is fixed, inside one that is not refined likewise; the rest is as new.
  EXPECT_EQ(value(ElementKind::edge, "fixed", 7), 1);
  EXPECT_EQ(value(ElementKind::edge, "fixed", 11), 0);
  EXPECT_EQ(value(ElementKind::edge, "no_refine", 7), 0);
  EXPECT_EQ(value(ElementKind::edge, "no_refine", 11), 1);
  EXPECT_EQ(value(ElementKind::edge, "original", 7), 0);
  EXPECT_EQ(value(ElementKind::vertex, "fixed", 6), 1);
  EXPECT_EQ(value(ElementKind::vertex, "fixed", 7), 0);
  EXPECT_EQ(value(ElementKind::vertex, "heat", 6), 0);
  EXPECT_EQ(film.columns(ElementKind::vertex).find("velocity")->value(6, 0), 0.25);
  EXPECT_EQ(film.columns(ElementKind::vertex).find("velocity")->value(6, 2), 1);
  EXPECT_EQ(scene.bodies.front().original, 5U);
  EXPECT_EQ(scene.bodies.front().density, 3);
}

// --- bodies

std::string tetrahedra(const std::string& bodies) {
  return "vertices\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\nedges\n1 1 2\n2 2 3\n3 3 1\n4 1 4\n5 2 "
         "4\n6 3 4\n"
         "7 1 5\n8 2 5\n9 3 5\nfaces\n1 -3 -2 -1\n2 1 5 -4\n3 2 6 -5\n4 3 4 -6\n5 7 -8 -1\n6 8 -9 -2\n7 9 -7 "
         "-3\n"
         "bodies\n" +
         bodies;
}

// What earlier versions saved had one number less.
TEST(Bodies, TakeUpTheMemoryOfVolumesOfEarlierFiles) {
  const scene::Scene scene = read("define body attribute volume_defect real[3]\n" +
                                  tetrahedra("7 1 2 3 4 volume 1/6 volume_defect {1,2,3}\n"))
                                 .scene;
  const film::Column* const memory = scene.body_columns.find("volume_defect");
  ASSERT_NE(memory, nullptr);
  EXPECT_EQ(memory->width, 4);
  EXPECT_EQ(memory->value(0, 0), 1);
  EXPECT_EQ(memory->value(0, 2), 3);
  EXPECT_EQ(memory->value(0, 3), 0);
}

TEST(Bodies, AreMeasured) {
  const scene::Scene scene = read(tetrahedra("7 1 2 3 4 volume 1/6\n3 -1 5 6 7 volconst 1\n")).scene;
  EXPECT_EQ(scene.bodies.size(), 2U);
  EXPECT_EQ(scene.bodies[0].original, 7U);
  EXPECT_EQ(scene.bodies[0].target_volume, 1.0 / 6);
  EXPECT_FALSE(scene.bodies[1].target_volume.has_value());
  EXPECT_DOUBLE_EQ(volume(scene, {1}), 1.0 / 6);
  EXPECT_DOUBLE_EQ(volume(scene, {2}), 1 + 1.0 / 6);
}

TEST(Bodies, TakeTheirVolumeConstantFromAnActualVolume) {
  const scene::Scene scene = read(tetrahedra("1 1 2 3 4 actual_volume 5\n2 -1 5 6 7\n")).scene;
  EXPECT_DOUBLE_EQ(volume(scene, {1}), 5);
}

TEST(Bodies, NameTheFewestFacesToTurn) {
  EXPECT_EQ(complaints(tetrahedra("1 1 2 -3 4\n")),
            "face 3 of body 1 faces the other way than its neighbours\n");
  EXPECT_EQ(complaints(tetrahedra("1 2 3 4 5 6 -7\n")),
            "face 7 of body 1 faces the other way than its neighbours\n");
  EXPECT_EQ(complaints(tetrahedra("1 -2 3 4 5 6 -7\n")),
            "faces 2, 7 of body 1 face the other way than their neighbours\n");
}

TEST(Bodies, AreToldOnceWhatIsWrongWithThem) {
  EXPECT_EQ(complaints(tetrahedra("1 1 2 3 4\n2 1 5 6 7\n")), "face 1 already bounds body 1 on this side\n");
  EXPECT_EQ(complaints(tetrahedra("1 -1 -2 -3 -4 volume 1/6\n")), "body 1 is listed inside out\n");
  EXPECT_EQ(complaints(tetrahedra("1 1 2 3 9\n")), "face 9 is not defined\n");
}

TEST(Bodies, MayBeOpenOnRims) {
  EXPECT_EQ(complaints(std::string(triangle) + "bodies\n1 1\n"), "");
  EXPECT_EQ(complaints(two_squares), "");
}

// Two walls that cross in a body: four of its faces meet at an edge.
TEST(Bodies, MayHoldFilmsWithin) {
  EXPECT_EQ(complaints(tetrahedra("1 2 3 4 5 6 7 1 -1 volume 1/3\n")), "");
}

// --- numbers and names

TEST(Mistakes, DoNotCauseOthers) {
  EXPECT_EQ(
      complaints(
          "vertices\n1 0 0\n2 1 0 0\n3 0 1 0\nedges\n1 1 2\n2 2 9\n3 3 1\nfaces\n1 1 2 3\nbodies\n1 1 2\n"),
      "vertex 1 has two coordinates, and needs three\nvertex 9 is not defined\nface 2 is not defined\n");
  EXPECT_EQ(complaints("vertices\n1.5 0 0 0\n2 1 0 0\nedges\n1 1 2\n"),
            "a whole number is needed here, not 1.5\n");
}

TEST(Attributes, MayStandOnTheNextLine) {
  const film::Film film =
      read("vertices\n1 0 0 0\nfixed\n2 1 0 0\nedges\n1 1 2 fixed\n  color red\n").scene.film;
  EXPECT_EQ(film.columns(ElementKind::vertex).find("fixed")->value(0), 1);
  EXPECT_EQ(film.columns(ElementKind::edge).find("color")->value(0), 4);
  EXPECT_EQ(complaints("vertices\n1 0 0 0\n2 1 0 0\nedges\nfixed\n1 1 2\n"),
            "\"fixed\" stands before the first edge\n");
}

TEST(Attributes, OfWholeNumbersAreCutOffAndMustFit) {
  const std::string declared = "define vertex attribute grade integer[2]\n";
  const film::Film film = read(declared + "vertices\n1 0 0 0 grade {2.9,-2.9}\n").scene.film;
  EXPECT_EQ(film.columns(ElementKind::vertex).find("grade")->value(0, 0), 2);
  EXPECT_EQ(film.columns(ElementKind::vertex).find("grade")->value(0, 1), -2);
  EXPECT_EQ(complaints(declared + "vertices\n1 0 0 0 grade 1 3e9\n"),
            "3000000000 is too large for an integer\n");
  EXPECT_EQ(complaints("vertices\n1 0 0 0 original 3e9\n"), "3000000000 is too large for an integer\n");
}

TEST(Mistakes, AreCountedFromTheTwentyFirstOn) {
  std::string content = "vertices\n1 0 0 0\nedges\n";
  for (int i = 1; i <= 50; ++i) content += std::to_string(i) + " 1 99\n";
  try {
    read(content);
    FAIL() << "fifty edges without an end were read";
  } catch (const text::Error& error) {
    ASSERT_EQ(error.diagnostics().size(), 21U);
    EXPECT_EQ(error.diagnostics().back().message, "30 more errors");
    EXPECT_FALSE(error.diagnostics().back().place.known());
  }
}

TEST(Warnings, NameBothVertices) {
  std::string content = "vertices\n";
  for (int i = 1; i <= 30; ++i) content += std::to_string(i) + " 0.1 0.2 0.3\n";
  const auto warnings = read(content).warnings;
  ASSERT_EQ(warnings.size(), 21U);
  EXPECT_EQ(warnings.front().message, "vertex 2 stands at the same point as vertex 1");
  EXPECT_EQ(warnings.back().message, "9 more warnings");
}

TEST(Parameters, MayUseEarlierOnesAndSpanLines) {
  const scene::Scene scene = read("PARAMETER one = 1\nparameter e := 2*one - 5\nparameter Two\n = \n 2\n" +
                                  std::string("parameter s = \"a text\"\ndefine count integer\n") + triangle)
                                 .scene;
  EXPECT_EQ(std::get<double>(scene.variables.find("e")->value), -3);
  EXPECT_EQ(std::get<double>(scene.variables.find("TWO")->value), 2);
  EXPECT_EQ(std::get<std::string>(scene.variables.find("s")->value), "a text");
  EXPECT_TRUE(scene.variables.find("two")->parameter);
  EXPECT_FALSE(scene.variables.find("count")->parameter);
}

TEST(Parameters, KeepTheirIdsInASession) {
  language::Variables session;
  session.id("other");
  const language::VariableId id = session.id("width");
  session.set(id, 7.0);
  const scene::Scene scene =
      datafile::read_datafile(text::make_source("test.fe", std::string("parameter width = 2\n") + triangle),
                              &session)
          .scene;
  EXPECT_EQ(std::get<double>(scene.variables.get(id)->value), 2);
  EXPECT_EQ(std::get<double>(session.get(id)->value), 7);
  EXPECT_EQ(scene.variables.find("other"), nullptr);
}

TEST(Settings, AreTaken) {
  const scene::Scene scene =
      read(std::string("gravity_constant 9.81\nscale: 0.25 fixed\nscale_limit 2\ntotal_time 3\n"
                       "symmetric_content\nzoom_vertex 2\n") +
           triangle)
          .scene;
  EXPECT_EQ(scene.gravity.constant, 9.81);
  EXPECT_EQ(scene.scale.value, 0.25);
  EXPECT_TRUE(scene.scale.fixed);
  EXPECT_EQ(scene.scale.limit, 2);
  EXPECT_EQ(scene.time, 3);
  EXPECT_TRUE(scene.symmetric_content);
  ASSERT_EQ(scene.cosmetics.size(), 1U);
  EXPECT_EQ(scene.cosmetics[0].keyword, "zoom_vertex");
  EXPECT_EQ(scene.cosmetics[0].text, "2");
}

TEST(Title, IsTheFirstComment) {
  EXPECT_EQ(read(std::string("// cube.fe\n//   A cube\n\n// not this\n") + triangle).scene.title,
            "cube.fe\n  A cube");
  EXPECT_EQ(read(std::string("/* cube.fe\n A cube\n*/\n") + triangle).scene.title, "cube.fe\nA cube");
  EXPECT_EQ(read(triangle).scene.title, "");
}

// --- macros and included files

TEST(Macros, AreReplacedWhereverAWordMayStand) {
  const film::Film film =
      read(
          "#define ONE 1\n#define Corner ONE 0\n#define EDGE_LIST edges\n#define minus_two -2\nvertices\n"
          "1 0 0 0\n2 Corner 0 \n3 0 minus_two -ONE\nEDGE_LIST\n1 1 2\n2 2 3\n3 3 ONE\n"
          "faces\n1 1 2 3\n")
          .scene.film;
  EXPECT_EQ(film.position(Vertex(1U)), (film::Vec3{1, 0, 0}));
  EXPECT_EQ(film.position(Vertex(2U)), (film::Vec3{0, -2, -1}));
}

TEST(Macros, AreUnknownAfterReadUnlessKept) {
  const std::string commands = "read\ngogo := { STEPS; print WIDE }\n// STEPS\nprint \"STEPS\"\n";
  const std::string macros = "#define WIDE 2 -3\n#define STEPS g 5; r\n";
  const auto dropped = read(macros + triangle + commands);
  ASSERT_EQ(dropped.read_section.size(), 1U);
  EXPECT_EQ(text_of(dropped.read_section[0]), "\ngogo := { STEPS; print WIDE }\n// STEPS\nprint \"STEPS\"\n");
  const auto kept = read("keep_macros\n" + macros + triangle + commands);
  EXPECT_EQ(text_of(kept.read_section[0]), "\ngogo := { g 5;r; print 2 -3 }\n// STEPS\nprint \"STEPS\"\n");
  EXPECT_EQ(text::line_and_column(kept.read_section[0]).line, 14);
}

// A folder with files, gone afterwards.
class IncludedFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (files::temp_directory_path() / "lamella-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    files::create_directory(folder_ / "parts");
    files::create_directory(folder_ / "library");
  }
  void TearDown() override { files::remove_all(folder_); }
  void write(const std::string& file, const std::string& content) {
    text::write_whole_file((folder_ / file).string(), content);
  }
  datafile::ReadResult load(const std::string& file) {
    return datafile::read_datafile((folder_ / file).string());
  }

  files::path folder_;
};

TEST_F(IncludedFiles, AreFoundBesideTheIncludingFile) {
  write("main.fe", "#include \"parts/top.inc\"\nvertices\n1 0 0 wide fixed #include \"parts/more.inc\"\n");
  write("parts/top.inc", "#include \"deeper.inc\"\n#define HIGH 7");
  write("parts/deeper.inc", "parameter wide = 3");
  write("parts/more.inc", "2 1 HIGH 0");
  const film::Film film = load("main.fe").scene.film;
  EXPECT_EQ(film.position(Vertex(0U)), (film::Vec3{0, 0, 3}));
  EXPECT_EQ(film.position(Vertex(1U)), (film::Vec3{1, 7, 0}));
}

TEST_F(IncludedFiles, AreFoundInTheFoldersOfEvolverpath) {
  write("main.fe", "#include \"common.inc\"\n");
  write("library/common.inc", triangle);
  EXPECT_THROW(load("main.fe"), text::Error);
  ::setenv("EVOLVERPATH", ("/nowhere:" + (folder_ / "library").string()).c_str(), 1);
  EXPECT_EQ(load("main.fe").scene.film.triangle_count(), 1U);
  ::unsetenv("EVOLVERPATH");
}

TEST_F(IncludedFiles, MayHoldTheCommands) {
  write("main.fe", std::string(triangle) + "#include \"parts/commands.inc\"\nr\n");
  write("parts/commands.inc", "read\ng 5\n");
  const auto result = load("main.fe");
  ASSERT_EQ(result.read_section.size(), 2U);
  EXPECT_EQ(text_of(result.read_section[0]), "\ng 5\n");
  EXPECT_EQ(text_of(result.read_section[1]), "\nr\n");
}

TEST_F(IncludedFiles, TellHowTheyIncludeThemselves) {
  write("main.fe", "#include \"parts/a.inc\"\n");
  write("parts/a.inc", "#include \"../parts/b.inc\"\n");
  write("parts/b.inc", "\n#include \"a.inc\"\n");
  try {
    load("main.fe");
    FAIL() << "an endless file was read";
  } catch (const text::Error& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U);
    EXPECT_EQ(error.diagnostics()[0].message, "a file includes itself: a.inc includes b.inc includes a.inc");
    EXPECT_EQ(text::line_and_column(error.diagnostics()[0].place).line, 2);
  }
}

TEST_F(IncludedFiles, MissingAsAWhole) {
  EXPECT_THROW(load("nothing.fe"), text::Error);
  EXPECT_THROW(load("parts"), text::Error);
}

// --- after `read`, and before the lists

TEST(Commands, OfTheTopSectionAreKept) {
  const auto result = read(
      "function real half(real a) {\n  if a > 0 then { return a/2; };\n  return 0; }\n"
      "procedure later(integer n);\nparameter one = 1\nprocedure now()\n{ print 3; }\n" +
      std::string(triangle) + "READ\ng\n");
  ASSERT_EQ(result.procedures.size(), 3U);
  EXPECT_EQ(text_of(result.procedures[0]),
            "function real half(real a) {\n  if a > 0 then { return a/2; };\n  return 0; }");
  EXPECT_EQ(text_of(result.procedures[1]), "procedure later(integer n);");
  EXPECT_EQ(text_of(result.procedures[2]), "procedure now()\n{ print 3; }");
  ASSERT_EQ(result.read_section.size(), 1U);
  EXPECT_EQ(text_of(result.read_section[0]), "\ng\n");
  EXPECT_TRUE(read(triangle).read_section.empty());
}

TEST(Variables, ArraysHoldWhatTheirBracesSay) {
  const auto result =
      read("define aa real[2][3] =\n{{1, 2, 3},\n {4}}\ndefine bb integer [4]\n" + std::string(triangle));
  const language::Variable* const aa = result.scene.variables.find("aa");
  ASSERT_NE(aa, nullptr);
  EXPECT_EQ(aa->array.shape, (std::vector<int>{2, 3}));
  EXPECT_EQ(aa->array.values, (std::vector<double>{1, 2, 3, 4, 0, 0}));
  EXPECT_EQ(result.scene.variables.find("bb")->array.values, std::vector<double>(4, 0.0));
  EXPECT_EQ(complaints("define aa real[2] = {1, 2, 3}\n" + std::string(triangle)),
            "these are more values than the array has room for\n");
  EXPECT_EQ(complaints("define aa string[2]\n" + std::string(triangle)), "arrays hold numbers\n");
}

TEST(Unsupported, FeaturesAreToldOnceEach) {
  EXPECT_EQ(complaints("diffusion 0.1\nmetric\n1 0 0\n0 1 0\n0 0 1\nconstraint 1\nformula: x7\n"
                       "vertices\n1 3 boundary 1\n"),
            "\"diffusion\" is not supported yet (diffusion of gas)\n"
            "\"metric\" is not supported yet (Riemannian metrics)\n");
}

}  // namespace

}  // namespace lamella::test
