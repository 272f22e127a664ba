// Numbers read straight from the bytes of a datafile: most of a large file is nothing else.
#pragma once

#include <cstdint>
#include <string_view>

namespace lamella::datafile {

// 1 for LF or CR, 2 for CR LF, 0 if no line ends at this byte.
std::uint32_t line_end_length(std::string_view content, std::size_t at);

// Past blanks, separators and spliced line ends.
std::uint32_t skip_blanks(std::string_view content, std::uint32_t at);

// The length of a decimal number, with a minus sign or without, that begins at this byte and stands alone:
// before a blank, a line's end or a closing brace. 0 if there is none, or if it is longer than 65535 bytes.
std::uint32_t plain_number(std::string_view content, std::size_t at, double& value);

}  // namespace lamella::datafile
