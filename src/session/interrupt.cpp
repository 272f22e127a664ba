#include "session/interrupt.h"

#include <csignal>
#include <ctime>
#include <string_view>

#include <unistd.h>

namespace lamella::session::interrupt {

namespace {

volatile std::sig_atomic_t flag = 0;
volatile std::time_t last_time = 0;

// Who presses again within a second is told that it was heard. Only functions that are safe in a handler.
void on_signal(int) {
  const std::time_t now = ::time(nullptr);
  if (flag != 0 && now - last_time <= 1) {
    constexpr std::string_view note = "\nstopping after the present step...\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, note.data(), note.size());
  }
  last_time = now;
  flag = 1;
}

}  // namespace

void watch() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, nullptr);
}

bool requested() {
  return flag != 0;
}

void clear() {
  flag = 0;
}

void request() {
  flag = 1;
}

}  // namespace lamella::session::interrupt
