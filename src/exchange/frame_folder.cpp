#include "exchange/frame_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "text/error.h"

namespace lamella::exchange {

FrameFolder::FrameFolder(const std::filesystem::path& file) {
  std::string name = file.string() + ".XXXXXX";
  if (::mkdtemp(name.data()) == nullptr)
    throw text::Error(fmt::format("cannot write \"{}\": {}", file.string(), std::strerror(errno)));
  path_ = name;
}

FrameFolder::~FrameFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void FrameFolder::release(const std::string& name, const std::filesystem::path& place) const {
  std::error_code failure;
  std::filesystem::rename(path_ / name, place, failure);
  if (failure) throw text::Error(fmt::format("cannot write \"{}\": {}", place.string(), failure.message()));
}

}  // namespace lamella::exchange
