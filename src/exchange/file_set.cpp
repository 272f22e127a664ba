#include "exchange/file_set.h"

#include <filesystem>

#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::exchange {

void write_files(const std::vector<NamedFile>& files) {
  std::vector<std::string> made;
  try {
    for (const NamedFile& file : files) {
      const bool is_new = !std::filesystem::exists(file.path);
      text::write_whole_file(file.path, file.content);
      if (is_new) made.push_back(file.path);
    }
  } catch (const text::Error&) {
    std::error_code ignored;
    for (const std::string& path : made) std::filesystem::remove(path, ignored);
    throw;
  }
}

}  // namespace lamella::exchange
