// Files read and written whole.
#pragma once

#include <string>
#include <string_view>

namespace lamella::text {

// The bytes of a file. Throws Error naming the path and the system's reason (no such file, a directory, no
// permission).
std::string read_whole_file(const std::string& path);

// Writes a file so that at every moment either the old or the whole new content stands under its name:
// a temporary file beside it, fsync, rename. Throws Error with the system's reason; then nothing has changed.
void write_whole_file(const std::string& path, std::string_view content);

}  // namespace lamella::text
