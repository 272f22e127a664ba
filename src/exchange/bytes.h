// Numbers as bytes, the lowest first.
#pragma once

#include <bit>
#include <cstring>
#include <string>

namespace lamella::exchange {

static_assert(std::endian::native == std::endian::little, "files are written as memory holds numbers");

template <class Number>
void append(std::string& bytes, Number value) {
  char block[sizeof value];
  std::memcpy(block, &value, sizeof value);
  bytes.append(block, sizeof value);
}

}  // namespace lamella::exchange
