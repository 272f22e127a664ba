#include "datafile/include_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <vector>

#include "text/whole_file.h"

namespace lamella::datafile {

namespace {

namespace files = std::filesystem;

// The folders in which an included file is looked for.
std::vector<files::path> include_folders(const std::string& including, const std::string& main_file) {
  std::vector<files::path> folders{files::path(including).parent_path(),
                                   files::path(main_file).parent_path()};
  const char* const listed = std::getenv("EVOLVERPATH");
  std::string_view rest = listed != nullptr ? listed : "";
  while (!rest.empty()) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    if (colon > 0) folders.emplace_back(rest.substr(0, colon));
    rest.remove_prefix(std::min(rest.size(), colon + 1));
  }
  return folders;
}

}  // namespace

text::SourcePointer read_text(const std::string& path) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::string content = text::read_whole_file(path);
  if (content.starts_with(byte_order_mark)) content.erase(0, byte_order_mark.size());
  return text::make_source(path, std::move(content));
}

std::string canonical_path_of(const std::string& path) {
  std::error_code ignored;
  return files::weakly_canonical(path, ignored).string();
}

std::optional<std::string> find_included(const std::string& name, const std::string& including,
                                         const std::string& datafile) {
  for (const files::path& folder : include_folders(including, datafile)) {
    const files::path candidate = folder / name;
    std::error_code ignored;
    if (files::exists(candidate, ignored)) return candidate.string();
  }
  return std::nullopt;
}

}  // namespace lamella::datafile
