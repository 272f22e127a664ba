// Ctrl-C. The one thing in the program that is global, for that is what signals are.
#pragma once

namespace lamella::session::interrupt {

// From now on Ctrl-C raises a flag and does nothing else. Reads that wait for the keyboard are broken off.
void watch();
bool requested();
void clear();
// As if Ctrl-C were pressed.
void request();

}  // namespace lamella::session::interrupt
