#include "datafile/reading.h"

#include <fmt/format.h>

namespace lamella::datafile {

void Reading::refuse(const text::Place& place, std::string_view word, std::string_view feature) {
  if (!refused.insert(feature).second) return;
  findings.error(place, fmt::format("\"{}\" is not supported yet ({})", word, feature));
}

}  // namespace lamella::datafile
