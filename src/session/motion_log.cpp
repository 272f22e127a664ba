#include "session/motion_log.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::session {

void MotionLog::begin(std::string path, long every) {
  text::write_whole_file(
      path,
      "time,energy,kinetic,work,balance,momentum_x,momentum_y,momentum_z,angular_x,angular_y,"
      "angular_z,volume_error,bound\n");
  path_ = std::move(path);
  every_ = every;
  steps_ = 0;
}

void MotionLog::note(const scene::Scene& scene, evolution::Motion& motion) {
  if (++steps_ % every_ != 0) return;
  const evolution::Balance whole = motion.balance();
  append(fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", scene.time, motion.energy(), whole.kinetic,
                     scene.work, motion.energy() + whole.kinetic - scene.work, whole.momentum.x,
                     whole.momentum.y, whole.momentum.z, whole.angular_momentum.x, whole.angular_momentum.y,
                     whole.angular_momentum.z, motion.volume_error(), motion.bound()));
}

void MotionLog::append(const std::string& text) const {
  std::FILE* const file = std::fopen(path_.c_str(), "a");
  const bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int code = errno;
  if (file != nullptr && std::fclose(file) == 0 && written) return;
  throw text::Error(fmt::format("cannot write \"{}\": {}", path_, std::strerror(code)));
}

}  // namespace lamella::session
