#include "session/terminal.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace lamella::session {

namespace {

void colour_word(std::string& text, std::string_view word, std::string_view code) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
    const std::string coloured = fmt::format("\x1b[{}m{}\x1b[0m", code, word);
    text.replace(at, word.size(), coloured);
    at += coloured.size();
  }
}

}  // namespace

bool colours_allowed(int descriptor) {
  const char* const no_color = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool refused = no_color != nullptr && *no_color != '\0';
  return ::isatty(descriptor) != 0 && !refused && terminal != nullptr && std::string_view(terminal) != "dumb";
}

void write_error(std::string_view message) {
  std::string text(message);
  if (colours_allowed(STDERR_FILENO)) {
    colour_word(text, "error:", "1;31");
    colour_word(text, "warning:", "1;33");
    colour_word(text, "note:", "1;36");
  }
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace lamella::session
