// Counts, areas and volumes right after loading, against Surface Evolver's (evolver_values.tsv).
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

#include "datafile/read.h"
#include "energy/measure.h"

namespace lamella::test {

namespace {

namespace files = std::filesystem;

struct Row {
  std::string file;
  std::vector<std::uint32_t> counts;
  double area = 0;
  double energy = 0;
  std::vector<double> volumes;  // of the first twenty bodies
};

std::vector<Row> evolver_rows() {
  std::vector<Row> rows;
  std::ifstream table(std::string(LAMELLA_SOURCE_DIR) + "/tests/datafile/evolver_values.tsv");
  std::string line;
  std::getline(table, line);  // the heading
  while (std::getline(table, line)) {
    std::istringstream fields(line);
    Row row;
    std::getline(fields, row.file, '\t');
    row.counts.resize(4);
    for (std::uint32_t& count : row.counts) fields >> count;
    fields >> row.area >> row.energy;
    std::string volumes;
    fields >> volumes;
    std::istringstream list(volumes == "-" ? "" : volumes);
    for (std::string volume; std::getline(list, volume, ',');) row.volumes.push_back(std::stod(volume));
    rows.push_back(std::move(row));
  }
  return rows;
}

bool is_example(const Row& row) {
  return files::path(row.file).is_absolute();
}

// Nothing where the file needs what is not supported.
std::optional<scene::Scene> load(const Row& row) {
  try {
    return datafile::read_datafile((files::path(LAMELLA_SOURCE_DIR) / row.file).string()).scene;
  } catch (const text::Error& error) {
    for (const text::Diagnostic& diagnostic : error.diagnostics()) {
      EXPECT_NE(diagnostic.message.find("not supported yet"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(is_example(row)) << error.what();
    return std::nullopt;
  }
}

// Whether the file could be compared.
bool check_values(const Row& row) {
  SCOPED_TRACE(row.file);
  const std::optional<scene::Scene> scene = load(row);
  if (!scene) return false;
  const std::vector<std::uint32_t> counts{scene->film.vertex_count(), scene->film.edge_count(),
                                          scene::facet_count(*scene), body_count(*scene)};
  EXPECT_EQ(counts, row.counts);
  const energy::Measures measures = energy::measure(*scene);
  EXPECT_NEAR(measures.area, row.area, 1e-12 * row.area);
  EXPECT_NEAR(measures.energy, row.energy, 1e-12 * std::abs(row.energy));
  for (std::size_t i = 0; i < row.volumes.size(); ++i) {
    EXPECT_NEAR(measures.volumes[i + 1], row.volumes[i], 1e-12 * std::max(1e-3, std::abs(row.volumes[i])));
  }
  return true;
}

TEST(EvolverValues, OfOurDatafilesAreOurs) {
  int compared = 0;
  for (const Row& row : evolver_rows()) compared += !is_example(row) && check_values(row) ? 1 : 0;
  EXPECT_GE(compared, 60);
}

TEST(EvolverValues, OfItsExamplesAreOurs) {
  if (!files::exists("/usr/share/doc/evolver/examples/cube.fe"))
    GTEST_SKIP() << "evolver-doc is not installed";
  int compared = 0;
  for (const Row& row : evolver_rows()) {
    if (is_example(row) && files::exists(row.file)) compared += check_values(row) ? 1 : 0;
  }
  EXPECT_GE(compared, 17);
}

}  // namespace

}  // namespace lamella::test
