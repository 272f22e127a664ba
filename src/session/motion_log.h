// A table of a moving film's energies, one row every so many steps.
#pragma once

#include <string>

#include "evolution/motion.h"

namespace lamella::session {

// What the command `log` remembers for `evolve`.
class MotionLog {
 public:
  // Begins a file with its header. Throws text::Error where it cannot be written.
  void begin(std::string path, long every);
  void end() { path_.clear(); }
  bool active() const { return !path_.empty(); }
  const std::string& path() const { return path_; }
  long every() const { return every_; }

  // A row for the state at a step's end, if it is the turn of one.
  void note(const scene::Scene& scene, evolution::Motion& motion);

 private:
  void append(const std::string& text) const;

  std::string path_;
  long every_ = 1;
  long steps_ = 0;
};

}  // namespace lamella::session
