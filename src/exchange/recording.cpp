#include "exchange/recording.h"

#include <filesystem>
#include <regex>

#include <fmt/format.h>

#include "exchange/frame_folder.h"
#include "exchange/mesh.h"
#include "exchange/video.h"
#include "exchange/vtk.h"
#include "picture/page.h"
#include "picture/png.h"
#include "text/error.h"
#include "text/suggest.h"
#include "text/whole_file.h"

namespace lamella::exchange {

namespace {

namespace fs = std::filesystem;

// Names of frames: what stands before and after the number, and its digits.
struct Numbering {
  std::string before;
  std::string after;
  int digits = 4;

  std::string name(long frame) const { return fmt::format("{}{:0{}}{}", before, frame, digits, after); }
};

// `frame-%04d.png`, or `frame.png`, which is frame-0000.png and so on.
Numbering numbering_of(const std::string& file) {
  static const std::regex pattern("^([^%]*)%(0?([1-9]?))d([^%]*)$");
  std::smatch match;
  if (std::regex_match(file, match, pattern))
    return {match[1], match[4], match[3].length() > 0 ? std::stoi(match[3]) : 1};
  if (file.find('%') != std::string::npos) {
    throw text::Error(fmt::format("\"{}\" does not tell how frames are numbered", file),
                      "the number stands as %04d: frame-%04d.png");
  }
  const fs::path path(file);
  return {path.stem().string() + "-", path.extension().string(), 4};
}

// Files that are numbered, moved to their folder at the end.
class NumberedFiles {
 public:
  NumberedFiles(const fs::path& file, Numbering numbering)
      : folder_(file), place_(file.parent_path()), numbering_(std::move(numbering)) {}

  std::string add(std::string_view content) {
    names_.push_back(numbering_.name(static_cast<long>(names_.size())));
    text::write_whole_file(folder_ / names_.back(), content);
    return names_.back();
  }
  void release() const {
    for (const std::string& name : names_) folder_.release(name, place_ / name);
  }
  // `frame-0000.png to frame-0099.png`
  std::string range() const {
    const auto path = [&](const std::string& name) { return (place_ / name).string(); };
    return names_.size() == 1 ? path(names_[0])
                              : fmt::format("{} to {}", path(names_.front()), names_.back());
  }

 private:
  FrameFolder folder_;
  fs::path place_;
  Numbering numbering_;
  std::vector<std::string> names_;
};

class PictureRecording : public Recording {
 public:
  PictureRecording(const fs::path& file, Numbering numbering) : files_(file, std::move(numbering)) {}

  void add(const scene::Scene& scene, const picture::PictureOptions& picture) override {
    files_.add(picture::encode_png(picture::render(scene, picture)));
    ++frames_;
  }
  std::string finish() override {
    files_.release();
    return files_.range();
  }

 private:
  NumberedFiles files_;
};

class VideoRecording : public Recording {
 public:
  VideoRecording(const fs::path& file, double rate)
      : folder_(file), file_(file), rate_(rate), name_("video" + text::lower(file.extension().string())) {}

  void add(const scene::Scene& scene, const picture::PictureOptions& picture) override {
    const picture::Image image = picture::render(scene, picture);
    if (!video_)
      video_ = VideoWriter::begin(folder_ / name_, folder_ / "log", image.width, image.height, rate_);
    if (!video_) throw text::Error("ffmpeg does not start");
    video_->add(image);
    ++frames_;
  }
  std::string finish() override {
    video_->finish();
    folder_.release(name_, file_);
    return file_.string();
  }

 private:
  FrameFolder folder_;
  fs::path file_;
  double rate_;
  std::string name_;
  std::unique_ptr<VideoWriter> video_;
};

class PageRecording : public Recording {
 public:
  PageRecording(const fs::path& file, double rate) : folder_(file), file_(file) {
    page_.frames_per_second = rate;
  }

  void add(const scene::Scene& scene, const picture::PictureOptions& picture) override {
    picture::add_frame(page_, scene, picture);
    ++frames_;
  }
  std::string finish() override {
    text::write_whole_file(folder_ / "page", write_page(page_));
    folder_.release("page", file_);
    return file_.string();
  }

 private:
  FrameFolder folder_;
  fs::path file_;
  picture::Page page_;
};

class SeriesRecording : public Recording {
 public:
  explicit SeriesRecording(const fs::path& file)
      : files_(file, {file.stem().string() + "-", ".vtp", 4}), file_(file) {}

  void add(const scene::Scene& scene, const picture::PictureOptions&) override {
    moments_.push_back({scene.time, files_.add(write_vtp(mesh_of(scene)))});
    ++frames_;
  }
  std::string finish() override {
    files_.release();
    text::write_whole_file(file_.string(), write_pvd(moments_));
    return file_.string();
  }

 private:
  NumberedFiles files_;
  fs::path file_;
  std::vector<Moment> moments_;
};

}  // namespace

std::unique_ptr<Recording> begin_recording(const std::string& path, double frames_per_second,
                                           std::string& warning) {
  const fs::path file(path);
  const std::string ending = text::lower(file.extension().string());
  if (ending == ".png")
    return std::make_unique<PictureRecording>(file, numbering_of(file.filename().string()));
  if (ending == ".html") return std::make_unique<PageRecording>(file, frames_per_second);
  if (ending == ".pvd") return std::make_unique<SeriesRecording>(file);
  if (ending == ".mp4" || ending == ".webm" || ending == ".mkv" || ending == ".mov" || ending == ".gif") {
    if (has_ffmpeg()) return std::make_unique<VideoRecording>(file, frames_per_second);
    warning = fmt::format("ffmpeg is not installed: frames are written as pictures instead of {}", path);
    return std::make_unique<PictureRecording>(file, Numbering{file.stem().string() + "-", ".png", 4});
  }
  throw text::Error(fmt::format("recordings are not written as \"{}\"", ending),
                    "known are .mp4, .webm, .mkv, .mov, .gif, .png (numbered), .html and .pvd");
}

}  // namespace lamella::exchange
