#include "datafile/evolver.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "text/whole_file.h"

namespace lamella::test {

namespace {

namespace files = std::filesystem;

// A folder of its own for each question, gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = (files::temp_directory_path() / "lamella-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { files::remove_all(path_); }
  const files::path& path() const { return path_; }

 private:
  files::path path_;
};

std::string output_of(const std::string& command) {
  std::string output;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  char block[4096];
  while (const std::size_t count = std::fread(block, 1, sizeof block, pipe)) output.append(block, count);
  ::pclose(pipe);
  return output;
}

}  // namespace

bool evolver_is_installed() {
  static const bool installed = std::system("command -v evolver > /dev/null 2>&1") == 0;
  return installed;
}

EvolverAnswer ask_evolver(const std::string& datafile_text) {
  const Folder folder;
  text::write_whole_file(folder.path() / "scene.fe", datafile_text);
  text::write_whole_file(folder.path() / "ask",
                         "printf \"counts %d %d %d %d %.17g %.17g\\n\", vertex_count, edge_count, "
                         "facet_count, body_count, total_area, total_energy\nq\nq\n");
  EvolverAnswer answer;
  answer.output =
      output_of(fmt::format("cd {} && timeout 60 evolver scene.fe < ask 2>&1", folder.path().string()));
  const std::size_t at = answer.output.rfind("counts ");
  if (at == std::string::npos || answer.output.find("ERROR") != std::string::npos) return answer;
  answer.loaded =
      std::sscanf(answer.output.c_str() + at, "counts %u %u %u %u %lf %lf", &answer.vertices, &answer.edges,
                  &answer.facets, &answer.bodies, &answer.area, &answer.energy) == 6;
  return answer;
}

}  // namespace lamella::test
