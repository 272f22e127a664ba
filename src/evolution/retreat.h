// What a motion goes back to when films have passed through one another.
//
// The film is known to be sound at some moments. Where it is found tangled later, it goes back to the last of
// them and tries again: with shorter steps, then with what tangled held together as rigid bodies, each of
// which keeps its momentum, then with more and more around it. (After the rigid impact zones of X. Provot,
// "Collision and self-collision handling in cloth model dedicated to design garments", 1997.)
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "surgery/tangle.h"

namespace lamella::evolution {

class Retreat {
 public:
  // The scene is sound now; or it is not known to be otherwise, and is looked at when it is needed.
  enum class Known { sound, unknown };
  void remember(const scene::Scene& scene, Known known);
  // Whether there is anything sound to go back to.
  bool ready();
  // The scene as it was, and what is to be held together from there on. False where that was tried too often;
  // the scene is then back there, too.
  bool go_back(scene::Scene& scene, const std::vector<surgery::Tangle>& tangles);

  // Of the steps that would be made otherwise. Each moment at which the film is sound doubles it, up to 1.
  double part_of_step() const { return part_; }
  const std::vector<surgery::Tangle>& held() const { return held_; }

 private:
  std::optional<scene::Scene> safe_;
  Known known_ = Known::unknown;
  std::vector<surgery::Tangle> held_;
  int attempts_ = 0;
  int looks_held_ = 0;
  double part_ = 1;
};

}  // namespace lamella::evolution
