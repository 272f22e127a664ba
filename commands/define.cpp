#include <cmath>

#include "datafile/attributes.h"
#include "session/session.h"
#include "text/suggest.h"

namespace lamella::session::commands {

namespace {

struct DefineOptions {
  Definition definition;
};

std::vector<int> shape_of(Session& session, const Definition& definition) {
  std::vector<int> shape;
  for (const language::Expression* const size : definition.sizes) {
    constexpr long most = 1000000;
    const long value = evaluate_count(*size, session.evaluation(), "a size");
    if (value < 1 || value > most)
      throw text::Error(size->place, fmt::format("a size of {} is not possible", value));
    shape.push_back(static_cast<int>(value));
  }
  return shape;
}

void define_variable(Session& session, const Definition& definition) {
  language::Variables& variables = session.scene().variables;
  if (!definition.sizes.empty()) {
    if (definition.type == "string")
      throw text::Error(definition.place, "arrays hold numbers: real or integer");
    variables.set_shape(variables.id(definition.name), shape_of(session, definition));
    return;
  }
  if (variables.find(definition.name) != nullptr) return;
  const language::Value blank =
      definition.type == "string" ? language::Value(std::string()) : language::Value(0.0);
  variables.set(variables.id(definition.name), blank);
}

// What fits of the old rows goes into the new ones.
void copy_values(const film::Column& from, film::Column& to, std::size_t rows) {
  if (from.shape.size() > 1 || to.shape.size() > 1) return;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (int i = 0; i < std::min(from.width, to.width); ++i) to.set(row, i, from.value(row, i));
  }
}

void define_attribute(Session& session, const Definition& definition) {
  const language::ElementKind kind = *definition.attribute_of;
  if (!session.attributes().summary(kind, definition.name).empty()) {
    throw text::Error(definition.place, fmt::format("{} have an attribute \"{}\" already",
                                                    language::plural_of(kind), definition.name));
  }
  if (definition.type == "string")
    throw text::Error(definition.place, "attributes are numbers: real or integer");
  const std::vector<int> shape = shape_of(session, definition);
  film::Columns& columns = columns_of(session.scene(), kind);
  if (kind == language::ElementKind::body) columns.resize(session.scene().bodies.size());
  const std::string name = text::lower(definition.name);
  const film::Column* const present = columns.find(name);
  if (present != nullptr && present->shape == shape) return;
  film::Column made = datafile::declared_column(film_kind(kind), name, definition.type == "integer", shape);
  made.resize(columns.rows());
  if (present != nullptr) copy_values(*present, made, columns.rows());
  columns.add(std::move(made));
}

void run(Session& session, const DefineOptions& options) {
  if (options.definition.attribute_of) {
    define_attribute(session, options.definition);
  } else {
    define_variable(session, options.definition);
  }
}

}  // namespace

extern const Command define_command = make_command<DefineOptions>(
    {.name = "define",
     .summary = "declare a variable, or an attribute of elements",
     .group = CommandGroup::language},
    {positional("[element attribute] name type", &DefineOptions::definition, "").required()}, run);

}  // namespace lamella::session::commands
