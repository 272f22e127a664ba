#include <fmt/format.h>

#include "session/command.h"

namespace lamella::session {

namespace {

std::string placeholder(const Argument& argument) {
  if (!argument.choices.empty()) return fmt::format("{}", fmt::join(argument.choices, "|"));
  std::string value;
  switch (argument.kind) {
    case ArgumentKind::number:
      value = "number";
      break;
    case ArgumentKind::count:
      value = "count";
      break;
    case ArgumentKind::text:
      value = "\"text\"";
      break;
    case ArgumentKind::file:
      value = "file";
      break;
    case ArgumentKind::formulas:
      value = "(formula, formula, formula)";
      break;
    case ArgumentKind::numbers:
      value = "(numbers)";
      break;
    case ArgumentKind::elements:
    case ArgumentKind::selection:
      value = "elements";
      break;
    case ArgumentKind::sample:
      value = "(elements, value)";
      break;
    case ArgumentKind::field:
      value = "formula";
      break;
    case ArgumentKind::commands:
      value = "{ commands }";
      break;
    default:
      value = "value";
      break;
  }
  return argument.word_for_none.empty() ? value : value + "|" + argument.word_for_none;
}

std::string upper(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

std::string shown(const Argument& argument) {
  if (argument.kind == ArgumentKind::flag) return argument.name;
  if (argument.named) return fmt::format("{} {}", argument.name, placeholder(argument));
  if (argument.kind == ArgumentKind::commands || argument.kind == ArgumentKind::sample)
    return placeholder(argument);
  return argument.choices.empty() ? upper(argument.name) : placeholder(argument);
}

}  // namespace

std::string usage(const Command& command) {
  std::string result = command.name;
  for (const Argument& argument : command.arguments) {
    result += argument.needed ? fmt::format(" {}", shown(argument)) : fmt::format(" [{}]", shown(argument));
  }
  return result;
}

std::string argument_help(const Command& command) {
  std::string result;
  for (const Argument& argument : command.arguments)
    result += fmt::format("  {:<24} {}\n", shown(argument), argument.help);
  return result;
}

}  // namespace lamella::session
