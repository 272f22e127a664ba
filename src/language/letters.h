// Commands of one letter that have been given another meaning (`r :::= { ... }`): procedures under a name
// that nothing else can have.
#pragma once

#include <string>
#include <string_view>

namespace lamella::language {

// The procedure's name for a letter; it stays different for `v` and `V` in lower case.
inline std::string letter_name(std::string_view letter) {
  const bool capital = letter.front() >= 'A' && letter.front() <= 'Z';
  return (capital ? "''" : "'") + std::string(letter) + "'";
}

// The letter of such a name, and empty for other names.
inline std::string_view letter_of(std::string_view name) {
  return name.starts_with('\'') ? name.substr(name.size() - 2, 1) : std::string_view{};
}

}  // namespace lamella::language
