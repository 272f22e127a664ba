#include "session/output.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::session {

namespace {

[[noreturn]] void fail(const std::string& path, int code) {
  throw text::Error(fmt::format("cannot write \"{}\": {}", path, std::strerror(code)));
}

void append(const std::string& path, std::string_view content) {
  std::FILE* const file = std::fopen(path.c_str(), "a");
  if (file == nullptr) fail(path, errno);
  const bool written =
      content.empty() || std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int code = errno;
  if (std::fclose(file) != 0 || !written) fail(path, written ? errno : code);
}

// That a file can be written is found out before the command runs, not after.
void check_writable(const std::string& path) {
  const bool existed = [&] {
    std::FILE* const file = std::fopen(path.c_str(), "r");
    if (file != nullptr) std::fclose(file);
    return file != nullptr;
  }();
  append(path, {});
  if (!existed) std::remove(path.c_str());
}

}  // namespace

Output::Output() {
  std::signal(SIGPIPE, SIG_IGN);
}

Output::~Output() {
  while (!targets_.empty()) cancel();
}

void Output::write(std::string_view text) {
  ++position_;
  if (!targets_.empty()) {
    Target& target = targets_.back();
    if (target.program == nullptr) {
      target.content += text;
    } else {
      // A program that has read enough is no error.
      std::fwrite(text.data(), 1, text.size(), target.program);
    }
    return;
  }
  if (text.empty()) return;
  at_line_start_ = text.back() == '\n';
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) throw OutputClosed{};
  constexpr std::chrono::milliseconds longest_wait{200};
  if (std::chrono::steady_clock::now() - flushed_ > longest_wait) flush();
}

void Output::flush() {
  flushed_ = std::chrono::steady_clock::now();
  if (std::fflush(stdout) != 0) throw OutputClosed{};
}

void Output::begin(language::Redirection kind, const std::string& target) {
  if (target.empty()) throw text::Error("output cannot go to a nameless file");
  Target made{kind, target, {}, nullptr};
  if (kind == language::Redirection::pipe) {
    flush();
    made.program = ::popen(target.c_str(), "w");
    if (made.program == nullptr)
      throw text::Error(fmt::format("cannot run \"{}\": {}", target, std::strerror(errno)));
  } else {
    check_writable(target);
  }
  targets_.push_back(std::move(made));
}

void Output::end() {
  const Target target = std::move(targets_.back());
  targets_.pop_back();
  switch (target.kind) {
    case language::Redirection::overwrite:
      text::write_whole_file(target.name, target.content);
      return;
    case language::Redirection::append:
      append(target.name, target.content);
      return;
    case language::Redirection::pipe: {
      const int status = ::pclose(target.program);
      constexpr int not_found = 127;
      if (status != -1 && ((status >> 8) & 0xff) == not_found) {
        throw text::Error(fmt::format("cannot run \"{}\"", target.name));
      }
      return;
    }
  }
}

void Output::cancel() {
  const Target target = std::move(targets_.back());
  targets_.pop_back();
  if (target.program != nullptr) ::pclose(target.program);
}

}  // namespace lamella::session
