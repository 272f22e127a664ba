#pragma once
#include <span>
namespace lamella::session {
struct Command;
}
