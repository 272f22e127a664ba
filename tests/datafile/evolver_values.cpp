// Counts, areas and volumes right after loading, against Surface Evolver's (evolver_values.tsv).
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "datafile/measures.h"
#include "datafile/read.h"

namespace lamella::test {

namespace {

namespace files = std::filesystem;

struct Row {
  std::string file;
  std::vector<std::uint32_t> counts;
  double area = 0;
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
    double energy = 0;
    for (std::uint32_t& count : row.counts) fields >> count;
    fields >> row.area >> energy;
    std::string volumes;
    fields >> volumes;
    std::istringstream list(volumes == "-" ? "" : volumes);
    for (std::string volume; std::getline(list, volume, ',');) row.volumes.push_back(std::stod(volume));
    rows.push_back(std::move(row));
  }
  return rows;
}

class EvolverValues : public testing::TestWithParam<Row> {};

TEST_P(EvolverValues, AreOurs) {
  const Row& row = GetParam();
  const files::path path = files::path(LAMELLA_SOURCE_DIR) / row.file;  // absolute rows stay what they are
  if (!files::exists(path)) GTEST_SKIP() << "the package evolver-doc is not installed";
  datafile::ReadResult result;
  try {
    result = datafile::read_datafile(path);
  } catch (const text::Error& error) {
    if (!files::path(row.file).is_absolute()) FAIL() << error.what();
    for (const text::Diagnostic& diagnostic : error.diagnostics()) {
      EXPECT_NE(diagnostic.message.find("not supported yet"), std::string::npos) << diagnostic.message;
    }
    GTEST_SKIP() << error.diagnostics().front().message;
  }
  const scene::Scene& scene = result.scene;
  const std::vector<std::uint32_t> counts{scene.film.vertex_count(), scene.film.edge_count(),
                                          scene.film.triangle_count(), body_count(scene)};
  EXPECT_EQ(counts, row.counts);
  EXPECT_NEAR(area(scene), row.area, 1e-12 * row.area);
  for (std::size_t i = 0; i < row.volumes.size(); ++i) {
    EXPECT_NEAR(volume(scene, {static_cast<std::uint32_t>(i + 1)}), row.volumes[i],
                1e-12 * std::max(1e-3, std::abs(row.volumes[i])));
  }
}

std::string test_name(const testing::TestParamInfo<Row>& info) {
  const files::path path = info.param.file;
  std::string name = path.parent_path().filename().string() + "_" + path.stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Table, EvolverValues, testing::ValuesIn(evolver_rows()), test_name);

}  // namespace

}  // namespace lamella::test
