// How a long computation hears of Ctrl-C and tells how far it is.
#pragma once

#include <string_view>

namespace lamella::scene {

// Polled between steps, never inside one: when it asks to stop, the film is in a valid state.
class Monitor {
 public:
  virtual ~Monitor() = default;
  virtual bool stop_requested() { return false; }
  // `done` of `total` steps (total 0 if unknown), with a word on the state, e.g. "energy 9.13942".
  // Called every step; whoever listens throttles.
  virtual void progress(long /*done*/, long /*total*/, double /*energy*/) {}
  // Whether someone looks at the scene between steps, so that it must be up to date when `progress` is
  // called.
  virtual bool watched() { return false; }
  // A line for the person at the prompt, kept in the output.
  virtual void say(std::string_view /*line*/) {}
};

}  // namespace lamella::scene
