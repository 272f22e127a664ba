// The line that shows how far a long computation is.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "scene/monitor.h"

namespace lamella::session {

// Draws on the standard error output, once a second has passed, and only if that is a terminal.
class Progress : public scene::Monitor {
 public:
  // `say` takes lines meant to stay.
  explicit Progress(std::function<void(std::string_view)> say);

  bool stop_requested() override;
  void progress(long done, long total, double energy) override;
  void say(std::string_view line) override;
  bool watched() override { return follower_ != nullptr; }

  // Called after each step; an empty function ends that.
  void follow(std::function<void()> follower) { follower_ = std::move(follower); }

  // A new computation begins; the line of the last one goes.
  void restart();
  // Makes room for other output.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  std::function<void(std::string_view)> say_;
  std::function<void()> follower_;
  bool terminal_ = false;
  Clock::time_point begin_;
  Clock::time_point drawn_;
  long first_ = 0;
  bool counting_ = false;
  bool visible_ = false;
};

// `12 of 500 steps, 31.2 steps/s, 16 s left, energy 9.13942`
std::string progress_line(long done, long total, double steps_per_second, double energy);

}  // namespace lamella::session
