// A place in one of the sources of a datafile, in eight bytes: rows of elements keep one for each number.
#pragma once

#include <cstdint>

namespace lamella::datafile {

struct Spot {
  std::uint32_t offset = 0;
  std::uint16_t source = 0;  // in the order in which the sources were opened (TokenSource::place)
  std::uint16_t length = 0;
};

}  // namespace lamella::datafile
