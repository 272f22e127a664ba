// What a step leaves of the volumes beyond first order, remembered so that the next can allow for it.
#pragma once

#include <algorithm>
#include <vector>

#include "film/ids.h"
#include "scene/scene.h"

namespace lamella::evolution {

// A step by dt along velocities that keep volumes to first order changes a volume by dt^2 times a number that
// varies slowly. It is extrapolated from the last two steps, which leaves an error that is two orders
// smaller; where the two differ much, the last one stands for the next. The memory travels in a column of the
// bodies, so that a run in two parts is the same run.
class VolumeMemory {
 public:
  // Rows as in `regions`.
  VolumeMemory(const scene::Scene& scene, std::vector<film::Region> regions);

  // What a step by dt is expected to leave.
  double expected(std::size_t row, double dt) const;
  // The largest part of its volume by which a body was missed of late: of earlier steps half counts, of those
  // before a quarter. Infinite without a memory.
  double miss() const { return miss_; }
  // What was foreseen has failed: as though a step had missed a volume by this part of it.
  void distrust(double miss);
  // What a step did leave, and by how much (in parts of the volume) that missed the volume wanted.
  void note(std::size_t row, double dt, double left, double missed, double volume);
  // After the notes of all rows.
  void finish();

  // How much of an error a correction leaves, 1 where that is not known.
  double rate() const { return rate_; }
  void note_rate(double rate) { rate_ = std::min(rate, 1.0); }

  void store(scene::Scene& scene) const;

 private:
  struct Row {
    double last = 0;
    double before = 0;
    double miss = 0;
  };
  std::vector<film::Region> regions_;
  std::vector<Row> rows_;
  double miss_ = 0;
  double rate_ = 1;
};

}  // namespace lamella::evolution
