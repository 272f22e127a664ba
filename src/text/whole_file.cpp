#include "text/whole_file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "text/error.h"

namespace lamella::text {

namespace {

[[noreturn]] void fail(std::string_view doing, const std::string& path, int code) {
  throw Error(fmt::format("cannot {} \"{}\": {}", doing, path, std::strerror(code)));
}

// A descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int get() const { return value_; }

  // Closes now and tells whether the system had an error to report at last.
  bool close() {
    const int value = value_;
    value_ = -1;
    return ::close(value) == 0;
  }

 private:
  int value_;
};

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// The permissions a new file gets by default, or those of the file that it replaces.
mode_t mode_for(const std::string& path) {
  struct stat existing = {};
  if (::stat(path.c_str(), &existing) == 0) return existing.st_mode & 0777U;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666U & ~mask;
}

bool is_regular_or_absent(const std::string& path) {
  struct stat existing = {};
  return ::stat(path.c_str(), &existing) != 0 || S_ISREG(existing.st_mode);
}

// A device or pipe (/dev/stdout, /dev/null) cannot be replaced, only written to.
void write_in_place(const std::string& path, std::string_view content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0 || !write_all(file.get(), content)) fail("write", path, errno);
}

}  // namespace

std::string read_whole_file(const std::string& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail("read", path, errno);
  struct stat status = {};
  if (::fstat(file.get(), &status) == 0 && S_ISDIR(status.st_mode)) fail("read", path, EISDIR);

  std::string content;
  if (status.st_size > 0) content.reserve(static_cast<std::size_t>(status.st_size));
  char block[1 << 16];
  while (true) {
    const ssize_t count = ::read(file.get(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("read", path, errno);
    if (count == 0) return content;
    content.append(block, static_cast<std::size_t>(count));
  }
}

void write_whole_file(const std::string& path, std::string_view content) {
  if (!is_regular_or_absent(path)) {
    write_in_place(path, content);
    return;
  }
  std::string temporary = path + ".XXXXXX";
  Descriptor file(::mkstemp(temporary.data()));
  if (file.get() < 0) fail("write", path, errno);
  const bool written = ::fchmod(file.get(), mode_for(path)) == 0 && write_all(file.get(), content) &&
                       ::fsync(file.get()) == 0 && file.close() &&
                       ::rename(temporary.c_str(), path.c_str()) == 0;
  if (!written) {
    const int code = errno;
    ::unlink(temporary.c_str());
    fail("write", path, code);
  }
}

}  // namespace lamella::text
