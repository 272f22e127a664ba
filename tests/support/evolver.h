// Surface Evolver, where it is installed: what it prints for a datafile and commands.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "support/folder.h"
#include "text/whole_file.h"

namespace lamella::trial {

inline bool evolver_is_installed() {
  static const bool installed = std::system("command -v evolver > /dev/null 2>&1") == 0;
  return installed;
}

// The examples of the package evolver-doc; the test that uses one must be skipped where it is missing.
inline std::string evolver_example(const std::string& name) {
  return "/usr/share/doc/evolver/fe/" + name + ".fe";
}

// Both outputs of a run that reads commands, one a line, from a file; it is stopped after a minute.
inline std::string evolver_output(const std::string& file, const std::string& commands) {
  const Folder folder;
  text::write_whole_file(folder / "ask", commands + "\nq\nq\n");
  std::string output;
  std::FILE* pipe =
      ::popen(fmt::format("timeout -s KILL 60 evolver {} < {} 2>&1", file, folder / "ask").c_str(), "r");
  if (pipe == nullptr) return output;
  char block[4096];
  while (const std::size_t count = std::fread(block, 1, sizeof block, pipe)) output.append(block, count);
  ::pclose(pipe);
  return output;
}

// What a number is after commands (one a line); not a number where the run does not come to the end.
inline double evolver_number(const std::string& file, const std::string& commands, const std::string& name) {
  const std::string said =
      evolver_output(file, fmt::format("{}\nprintf \"is %.17g\\n\", {}", commands, name));
  const std::size_t at = said.rfind("is ");
  return at == std::string::npos ? std::nan("") : std::strtod(said.c_str() + at + 3, nullptr);
}

}  // namespace lamella::trial
