// Values in the top section of a datafile, where line ends mean little.
#pragma once

#include <string>

#include "datafile/reading.h"
#include "language/evaluate.h"
#include "language/formula.h"

namespace lamella::datafile {

// Whether a value stands next, on this line or the following; passes over the line ends before it.
bool top_value_follows(Reading& reading);

// That value. Throws text::Error at what stands there instead, with the message `missing`.
double top_value(Reading& reading, const std::string& missing);

// The same as a formula of the variables so far, which can be evaluated again when they have changed.
language::Formula top_value_of_variables(Reading& reading, const std::string& missing);

// The number or text of a formula that stands next. Throws text::Error, also where a number is not finite.
language::Value top_formula(Reading& reading);

}  // namespace lamella::datafile
