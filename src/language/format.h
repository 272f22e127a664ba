// printf's formats.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "language/variables.h"

namespace lamella::language {

// %d %i %u %x %X %o %c take a number (cut to a whole one), %f %e %g %a (either case) a number, %s a string (a
// number is written as print does), %% nothing; flags, width and precision as in C, also as `*`. Throws
// text::Error without a place where formats and values do not match in number or kind.
std::string format_values(std::string_view format, std::span<const Value> values);

// A number as print writes it: 15 significant digits, no more than needed.
std::string format_number(double value);

}  // namespace lamella::language
