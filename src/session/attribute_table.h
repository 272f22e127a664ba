// The attributes that every scene has, and the columns behind them.
#pragma once

#include <deque>

#include "session/attributes.h"

namespace lamella::session {

std::deque<AttributeRow> built_in_attributes();

// The value in a column, or what elements have where there is no such column.
double column_value(const AttributeSource& source, const language::Element& element, const std::string& name,
                    int component);
// The column of a known attribute, made if there is none.
film::Column& made_column(const AttributeSource& source, language::ElementKind kind, const std::string& name);
// Throws text::Error for what is no color.
double checked_color(double value);

}  // namespace lamella::session
