// The top section of a datafile: settings, parameters, declarations of attributes, cosmetic words.
#pragma once

#include <string>

#include "datafile/reading.h"

namespace lamella::datafile {

// Reads up to the first list of elements, whose keyword is left to be taken, or to the end.
void read_top_section(Reading& reading);

// Whether a value stands next, on this line or the following; passes over the line ends before it.
bool top_value_follows(Reading& reading);
// That value. Throws text::Error at what stands there instead, with the message `missing`.
double top_value(Reading& reading, const std::string& missing);

// A parameter by which saved files carry a setting that has no word of its own in the language.
struct SettingParameter {
  std::string_view name;
  double (*get)(const scene::Scene&);
  void (*set)(scene::Scene&, double);
  double blank = 0;  // the value of a new scene
};
std::span<const SettingParameter> setting_parameters();

}  // namespace lamella::datafile
