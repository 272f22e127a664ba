// Any bytes as a datafile: they make a scene, or text::Error.
#include <cstddef>
#include <cstdint>
#include <string>

#include "datafile/read.h"
#include "datafile/write.h"
#include "text/error.h"

using namespace lamella;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(bytes), size);
  // Files that it might include have nothing to do with it.
  if (text.find("#include") != std::string::npos) return 0;
  try {
    const datafile::ReadResult result =
        datafile::read_datafile(text::make_source("fuzz.fe", std::move(text)));
    datafile::write_datafile(result.scene);
  } catch (const text::Error&) {
  }
  return 0;
}
