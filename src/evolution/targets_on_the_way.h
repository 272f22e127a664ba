// How far volumes are from their targets; those that are far are brought there by strides.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lamella::evolution {

// The largest part of a target volume that the film lacks, or has too much; infinite where a volume is no
// number.
double missing_volume(const scene::Scene& scene);

// While it lives the bodies of a scene may have other targets than those wanted: `stride` sets them a part of
// the way from the present volumes, in proportion. Afterwards the bodies have the targets wanted.
class TargetsOnTheWay {
 public:
  explicit TargetsOnTheWay(scene::Scene& scene);
  ~TargetsOnTheWay();
  TargetsOnTheWay(const TargetsOnTheWay&) = delete;
  TargetsOnTheWay& operator=(const TargetsOnTheWay&) = delete;

  // False where all that are wanted lie within a stride: then those are set. Volumes of the wrong sign, and
  // those of periodic films, take no strides.
  bool stride();

 private:
  scene::Scene& scene_;
  std::vector<film::Region> bodies_;
  std::vector<double> wanted_;
};

}  // namespace lamella::evolution
