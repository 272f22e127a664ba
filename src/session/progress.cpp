#include "session/progress.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "session/interrupt.h"

namespace lamella::session {

namespace {

constexpr std::chrono::milliseconds before_first{1000};
constexpr std::chrono::milliseconds between{200};

std::string duration(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 90) return fmt::format("{} s", whole);
  if (whole < 90 * 60) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string progress_line(long done, long total, double steps_per_second, double energy) {
  std::string line = total > 0 ? fmt::format("{} of {} steps", done, total) : fmt::format("{} steps", done);
  if (steps_per_second > 0) {
    line += fmt::format(", {:.3g} steps/s", steps_per_second);
    if (total > done)
      line += fmt::format(", {} left", duration(static_cast<double>(total - done) / steps_per_second));
  }
  return line + fmt::format(", energy {:.9g}", energy);
}

Progress::Progress(std::function<void(std::string_view)> say)
    : say_(std::move(say)), terminal_(::isatty(STDERR_FILENO) != 0) {
  restart();
}

void Progress::restart() {
  erase();
  counting_ = false;
}

bool Progress::stop_requested() {
  return interrupt::requested();
}

void Progress::progress(long done, long total, double energy) {
  if (follower_) follower_();
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (!counting_ || done < first_) {
    counting_ = true;
    begin_ = now;
    drawn_ = now;
    first_ = done;
    return;
  }
  if (now - begin_ < before_first || now - drawn_ < between) return;
  drawn_ = now;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const std::string line = progress_line(done, total, static_cast<double>(done - first_) / seconds, energy);
  fmt::print(stderr, "\r{}\x1b[K", line);
  std::fflush(stderr);
  visible_ = true;
}

void Progress::say(std::string_view line) {
  erase();
  say_(line);
}

void Progress::erase() {
  if (!visible_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  visible_ = false;
}

}  // namespace lamella::session
