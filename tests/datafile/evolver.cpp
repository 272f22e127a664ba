#include "datafile/evolver.h"

#include <cstdio>

#include "support/evolver.h"

namespace lamella::test {

EvolverAnswer ask_evolver(const std::string& datafile_text) {
  const trial::Folder folder;
  EvolverAnswer answer;
  answer.output =
      trial::evolver_output(folder.write("scene.fe", datafile_text),
                            "printf \"counts %d %d %d %d %.17g %.17g\\n\", vertex_count, edge_count, "
                            "facet_count, body_count, total_area, total_energy");
  const std::size_t at = answer.output.rfind("counts ");
  if (at == std::string::npos || answer.output.find("ERROR") != std::string::npos) return answer;
  answer.loaded =
      std::sscanf(answer.output.c_str() + at, "counts %u %u %u %u %lf %lf", &answer.vertices, &answer.edges,
                  &answer.facets, &answer.bodies, &answer.area, &answer.energy) == 6;
  return answer;
}

}  // namespace lamella::test
