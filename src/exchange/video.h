// Videos by ffmpeg.
#pragma once

#include <memory>
#include <string>

#include "picture/image.h"

namespace lamella::exchange {

// ffmpeg at work, taking pictures of one size.
class VideoWriter {
 public:
  // Null where there is no ffmpeg. The video is `file`; what ffmpeg complains of goes to `log`.
  static std::unique_ptr<VideoWriter> begin(const std::string& file, const std::string& log, int width,
                                            int height, double frames_per_second);
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  // Stops ffmpeg where the video is not finished.
  ~VideoWriter();

  // Both throw text::Error with what ffmpeg says.
  void add(const picture::Image& image);
  void finish();

 private:
  VideoWriter() = default;
  [[noreturn]] void fail();

  int process_ = -1;
  int pipe_ = -1;
  std::string log_;
};

bool has_ffmpeg();

}  // namespace lamella::exchange
