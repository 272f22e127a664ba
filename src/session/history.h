// What `undo` and `redo` return to.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace lamella::session {

// Whether anything that a scene keeps differs from a copy made before. Compares arrays by revision, so it is
// quick.
bool differs(const scene::Scene& a, const scene::Scene& b);

class History {
 public:
  // Oldest steps are dropped when those kept need more memory than this.
  explicit History(std::size_t most_bytes = std::size_t{1} << 30U) : most_bytes_(most_bytes) {}

  // A statement changed the scene from `before`. What was undone before cannot be redone any more.
  void push(scene::Scene before, std::string statement);
  // Puts the scene back by one step (or forth); returns the statement, or nothing if there is none.
  std::optional<std::string> undo(scene::Scene& scene);
  std::optional<std::string> redo(scene::Scene& scene);

  std::size_t undo_steps() const { return past_.size(); }
  std::size_t redo_steps() const { return future_.size(); }

 private:
  struct Step {
    scene::Scene scene;
    std::string statement;
  };
  void drop_oldest();

  std::size_t most_bytes_;
  std::vector<Step> past_;
  std::vector<Step> future_;
};

}  // namespace lamella::session
