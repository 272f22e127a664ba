#include "exchange/video.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "text/error.h"

extern char** environ;

namespace lamella::exchange {

namespace {

// Colours of a gif are chosen once for all frames; a video has even sides, and starts before it is all there.
std::vector<std::string> encoding(const std::string& ending) {
  if (ending == ".gif") {
    return {"-filter_complex",
            "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a", "-loop", "0"};
  }
  std::vector<std::string> words = {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"};
  if (ending == ".webm") {
    words.insert(words.end(), {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0"});
  } else {
    words.insert(words.end(), {"-c:v", "libx264", "-crf", "17", "-preset", "medium"});
  }
  if (ending == ".mp4" || ending == ".mov") words.insert(words.end(), {"-movflags", "+faststart"});
  return words;
}

std::vector<std::string> command(const std::string& file, int width, int height, double rate) {
  std::vector<std::string> words = {"ffmpeg",
                                    "-y",
                                    "-nostdin",
                                    "-loglevel",
                                    "error",
                                    "-f",
                                    "rawvideo",
                                    "-pixel_format",
                                    "rgba",
                                    "-video_size",
                                    fmt::format("{}x{}", width, height),
                                    "-framerate",
                                    fmt::format("{}", rate),
                                    "-i",
                                    "-"};
  for (std::string& word : encoding(std::filesystem::path(file).extension().string()))
    words.push_back(std::move(word));
  words.push_back(file);
  return words;
}

// Starts a program with its standard input from a pipe; -1 where there is none. In a group of its own, so
// that Ctrl-C is for us to answer.
int spawn(std::vector<std::string> words, int input, const std::string& log) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = -1;
  const int status = posix_spawnp(&process, arguments[0], &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return status == 0 ? process : -1;
}

}  // namespace

bool has_ffmpeg() {
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int process = spawn({"ffmpeg", "-version"}, nothing, "/dev/null");
  ::close(nothing);
  int status = -1;
  return process > 0 && ::waitpid(process, &status, 0) == process && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

std::unique_ptr<VideoWriter> VideoWriter::begin(const std::string& file, const std::string& log, int width,
                                                int height, double frames_per_second) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return nullptr;
  const int process = spawn(command(file, width, height, frames_per_second), ends[0], log);
  ::close(ends[0]);
  std::unique_ptr<VideoWriter> writer(new VideoWriter);
  writer->pipe_ = ends[1];
  writer->process_ = process;
  writer->log_ = log;
  return process > 0 ? std::move(writer) : nullptr;
}

VideoWriter::~VideoWriter() {
  if (pipe_ >= 0) ::close(pipe_);
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void VideoWriter::fail() {
  std::ifstream file(log_);
  std::string line;
  std::getline(file, line);
  throw text::Error("ffmpeg cannot make the video",
                    line.empty() ? "it says nothing of why" : "it says: " + line);
}

void VideoWriter::add(const picture::Image& image) {
  const char* at = reinterpret_cast<const char*>(image.pixels.data());
  std::size_t left = image.pixels.size() * sizeof(picture::Pixel);
  while (left > 0) {
    const ssize_t written = ::write(pipe_, at, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    at += written;
    left -= static_cast<std::size_t>(written);
  }
}

void VideoWriter::finish() {
  ::close(pipe_);
  pipe_ = -1;
  int status = -1;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail();
}

}  // namespace lamella::exchange
