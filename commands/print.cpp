#include "language/format.h"
#include "session/session.h"
#include "text/suggest.h"

namespace lamella::session::commands {

namespace {

struct PrintOptions {
  Printable what;
};

// {1, 2, 3}; a matrix has a line for each row.
std::string array_text(const language::Array& array, std::size_t dimension, std::size_t& next) {
  std::string result = "{";
  for (int i = 0; i < array.shape[dimension]; ++i) {
    const bool innermost = dimension + 1 == array.shape.size();
    if (i > 0) result += innermost ? ", " : ",\n ";
    result +=
        innermost ? language::format_number(array.values[next++]) : array_text(array, dimension + 1, next);
  }
  return result + "}";
}

std::string value_text(const language::Value& value) {
  if (const double* const number = std::get_if<double>(&value))
    return language::format_number(*number) + "\n";
  const std::string& text = std::get<std::string>(value);
  return text.ends_with('\n') ? text : text + "\n";
}

void run(Session& session, const PrintOptions& options) {
  if (const auto* const name = std::get_if<ProcedureName>(&options.what)) {
    const language::Procedures& procedures = session.scene().procedures;
    const auto at = procedures.find(name->name);
    if (at == procedures.end()) throw text::Error("there is no procedure \"" + name->name + "\"");
    session.print("{}\n", at->second.source);
    return;
  }
  const language::Expression& expression = *std::get<const language::Expression*>(options.what);
  if (const auto array = evaluate_array(expression, session.evaluation())) {
    std::size_t next = 0;
    session.print("{}\n", array_text(*array, 0, next));
    return;
  }
  session.write(value_text(evaluate(expression, session.evaluation())));
}

}  // namespace

extern const Command print_command = make_command<PrintOptions>(
    {.name = "print", .summary = "print a value, a string or a procedure", .group = CommandGroup::output},
    {positional("value", &PrintOptions::what, "a number, a string, an array or a procedure's name")
         .required()},
    run);

}  // namespace lamella::session::commands
