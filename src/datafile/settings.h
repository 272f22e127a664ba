// Settings of a scene that the top section of a datafile gives.
#pragma once

#include <span>
#include <string_view>

#include "datafile/reading.h"

namespace lamella::datafile {

struct Setting {
  std::string_view word;
  // Takes what follows the word, which is taken already.
  void (*read)(Reading& reading, const language::Token& word) = nullptr;
};

std::span<const Setting> settings();
// Null if there is none.
const Setting* find_setting(std::string_view word);

// A parameter by which saved files carry a setting that has no word of its own in the language.
struct SettingParameter {
  std::string_view name;
  double (*get)(const scene::Scene&) = nullptr;
  void (*set)(scene::Scene&, double) = nullptr;
  double blank = 0;  // the value of a new scene
};

std::span<const SettingParameter> setting_parameters();
const SettingParameter* find_setting_parameter(std::string_view name);

}  // namespace lamella::datafile
