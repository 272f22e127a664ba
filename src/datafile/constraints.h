// Level sets and boundaries: their declarations in the top section.
#pragma once

#include <array>
#include <string_view>

#include "datafile/reading.h"
#include "language/formula_scope.h"

namespace lamella::datafile {

// These take what follows `constraint` and `boundary`, which are taken already.
void read_constraint(Reading& reading, const language::Token& word);
void read_boundary(Reading& reading, const language::Token& word);

// The number of a constraint or boundary that is declared, from its number or name; 0 if there is none.
int declared_constraint(const Reading& reading, const language::Token& token);
int declared_boundary(const Reading& reading, const language::Token& token);

// Formulas on lines of their own, `x1: formula` to `x3: formula` for the letter x. Throws text::Error if the
// first line is no such line.
std::array<language::Formula, 3> read_components(Reading& reading, std::string_view letter,
                                                 language::FormulaKind kind, film::ElementKind element);

// A formula on what is left of this line. It may read what the user has defined for an element of this kind.
language::Formula read_formula(Reading& reading, language::FormulaKind kind, film::ElementKind element);

}  // namespace lamella::datafile
