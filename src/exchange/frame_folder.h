// A folder beside a file, for what is not finished.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lamella::exchange {

// Gone, with what is in it, when this is.
class FrameFolder {
 public:
  // Beside the file of this path. Throws text::Error with the system's reason.
  explicit FrameFolder(const std::filesystem::path& file);
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;
  ~FrameFolder();

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  // Moves a file of the folder into its place, over what is there.
  void release(const std::string& name, const std::filesystem::path& place) const;

 private:
  std::filesystem::path path_;
};

}  // namespace lamella::exchange
