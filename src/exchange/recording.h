// Moments of a moving film as a film of pictures, a page that plays them or a series of meshes.
#pragma once

#include <memory>
#include <string>

#include "picture/show.h"
#include "scene/scene.h"

namespace lamella::exchange {

// Frames go to a folder of their own beside the file; only `finish` puts them into place. A recording that is
// given up leaves nothing behind.
class Recording {
 public:
  Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  virtual ~Recording() = default;

  // The scene as it is now; `picture` has a framing, so that all frames are seen alike. Throws text::Error.
  virtual void add(const scene::Scene& scene, const picture::PictureOptions& picture) = 0;
  // Returns the name of what was written, for people. Throws text::Error.
  virtual std::string finish() = 0;

  long frames() const { return frames_; }

 protected:
  long frames_ = 0;
};

// By the path's ending:
//
//   .mp4 .webm .mkv .mov .gif  pictures through ffmpeg, `frames_per_second` of them a second
//   .png                       pictures, numbered where the name has %04d, or NAME-0000.png and so on
//   .html                      a page that plays the frames
//   .pvd                       meshes NAME-0000.vtp and so on, with their times, for ParaView
//
// Where ffmpeg is missing, pictures are written instead, and `warning` tells so. Throws text::Error for other
// endings and where nothing can be written.
std::unique_ptr<Recording> begin_recording(const std::string& path, double frames_per_second,
                                           std::string& warning);

}  // namespace lamella::exchange
