#include "chart/evolver.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "datafile/write.h"
#include "text/error.h"

namespace lamella::chart {

namespace {

namespace files = std::filesystem;

// A folder that is gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = (files::temp_directory_path() / "lamella-chart-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw text::Error("no folder could be made for Evolver's files");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    files::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  files::path operator/(const char* name) const { return path_ / name; }

 private:
  files::path path_;
};

constexpr double growth = 1.03;
constexpr const char* tell = "printf \"sample %.9g %d %.17g\\n\", clock-begun, facet_count, total_energy; ";

std::string descent(const RaceOptions& options) {
  return fmt::format(
      "do {{ was := total_energy; g 10; {0} }} while (was - total_energy > 1e-8*abs(was) and clock-begun < "
      "{1}); ",
      tell, options.limit);
}

// What it does at each level.
std::string level_commands(const std::string& mode, const RaceOptions& options) {
  if (mode == "evolver_g") return descent(options);
  if (mode == "evolver_U") return "U; " + descent(options) + "U; ";
  std::string text = "g 5; u; V; u; V; g 5; ";
  for (int i = 0; i < 4; ++i) text += fmt::format("hessian_seek; {}", tell);
  for (int i = 0; i < 2; ++i) text += fmt::format("hessian; {}", tell);
  return text;
}

std::string script(const std::string& mode, const RaceOptions& options) {
  std::string text = "quiet\nbegun := clock\n";
  for (long level = 0; level <= options.levels; ++level) {
    text += fmt::format("if clock-begun < {} then {{ {} {} }}\n", options.limit, level > 0 ? "r;" : "",
                        level_commands(mode, options));
  }
  return text + "q\nq\n";
}

}  // namespace

const std::vector<std::string>& evolver_modes() {
  static const std::vector<std::string> names{"evolver_g", "evolver_U", "evolver_hessian"};
  return names;
}

bool evolver_installed() {
  return std::system("command -v evolver > /dev/null 2>&1") == 0;
}

Curve run_evolver(const std::string& mode, const scene::Scene& scene, const RaceOptions& options) {
  const Folder folder;
  std::ofstream(folder / "scene.fe") << datafile::write_datafile(scene);
  std::ofstream(folder / "commands") << script(mode, options);
  // Far beyond its own limit it hangs: a factorisation cannot be interrupted from within.
  const std::string command = fmt::format("timeout {} evolver {} < {} 2> /dev/null", 10 * options.limit + 60,
                                          (folder / "scene.fe").string(), (folder / "commands").string());
  Curve curve{mode, {}};
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return curve;
  char line[1024];
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    const std::string_view text(line);
    const std::size_t at = text.find("sample ");
    Sample sample;
    if (at == std::string_view::npos ||
        std::sscanf(line + at, "sample %lf %u %lf", &sample.seconds, &sample.facets, &sample.energy) != 3)
      continue;
    // As dense as those of the other methods, the last one always.
    if (curve.samples.size() > 1 && sample.seconds < growth * (curve.samples.end() - 2)->seconds)
      curve.samples.back() = sample;
    else
      curve.samples.push_back(sample);
  }
  ::pclose(pipe);
  return curve;
}

}  // namespace lamella::chart
