// Appends to the text of a datafile.
#pragma once

#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace lamella::datafile {

template <class... Arguments>
void put(std::string& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
}

}  // namespace lamella::datafile
