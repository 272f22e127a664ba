// Volume correction by areas and normals, as Ishida et al. 2017 have it (section 4.2 and appendix B), to
// compare with.
#pragma once

#include <span>
#include <vector>

#include "film/film.h"
#include "solve/gram_solver.h"

namespace lamella::evolution {

// Each film between regions i and j moves along its normal by d_i - d_j, where A d = dV, A the graph
// Laplacian of the regions weighted by the areas of the films between them; regions without a row have d = 0.
// A vertex where films meet moves so that it follows all of them best: by the displacement w that minimises
// the sum of area (w.n - d)^2 over its triangles, without a part along directions that none of them sees.
class PaperCorrection {
 public:
  // row_of_region[r] is the row of region r, or -1.
  PaperCorrection(const film::Film& film, std::vector<int> row_of_region, int rows);

  // The displacements (a row a vertex) that change the volumes by `errors` to first order; `levels` are the d
  // of the rows. False if the system is singular.
  bool displacements(std::span<const film::Vec3> x, std::span<const double> errors, std::span<double> levels,
                     std::span<film::Vec3> result);

 private:
  struct Triangle {
    std::array<film::Vertex, 3> corners;
    int behind = -1;
    int front = -1;
    int entry_behind = -1;  // where their products stand in the pattern
    int entry_front = -1;
    int entry_mixed = -1;
  };
  std::vector<Triangle> triangles_;
  std::vector<energy::GramEntry> pattern_;
  std::vector<double> values_;
  std::vector<std::array<double, 9>> sums_;  // of each vertex: area n n^T (xx xy xz yy yz zz), area d n
  solve::GramSolver solver_;
};

}  // namespace lamella::evolution
