// Functions of the language that make elements: they change the scene and return the new number.
#pragma once

#include <span>
#include <string_view>

#include "language/scope.h"
#include "language/variables.h"

namespace lamella::session {

class Session;

struct SceneFunction {
  std::string_view name;
  std::string_view summary;
  language::Arity arity;
  language::Value (*run)(Session&, std::span<const language::Value> arguments) = nullptr;
};

std::span<const SceneFunction> scene_functions();
// Null if there is none. Case does not matter.
const SceneFunction* find_scene_function(std::string_view name);

}  // namespace lamella::session
