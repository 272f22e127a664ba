// What loading a file of datafiles/ must say: its .expected file (datafiles/README.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/error.h"

namespace lamella::test {

struct ExpectedMessage {
  text::Severity severity = text::Severity::error;
  std::string file;  // its last part; empty for the datafile itself
  int line = 0;
  int column = 0;
  std::vector<std::string> phrases;  // small letters
};

struct Expectation {
  int status = 0;
  std::vector<ExpectedMessage> messages;
  std::vector<std::uint32_t> counts;  // vertices, edges, facets, bodies; empty if not given
  std::optional<double> area;
};

Expectation read_expectation(const std::string& path);

// What is wrong with messages, or nothing. A last one without a place, which counts what was left out, is
// allowed.
std::string difference(const std::vector<ExpectedMessage>& expected,
                       const std::vector<text::Diagnostic>& found, const std::string& datafile);

// The .fe files of a folder below the source's root, sorted.
std::vector<std::string> datafiles_in(const std::string& folder);

}  // namespace lamella::test
