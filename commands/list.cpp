#include "datafile/write.h"
#include "language/letters.h"
#include "session/listing.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ListOptions {
  std::string what;
  std::optional<Elements> elements;
};

void list_variables(Session& session) {
  const language::Variables& variables = session.scene().variables;
  variables.for_each([&](language::VariableId id, const language::Variable& variable) {
    if (variable.is_array()) {
      session.print("{} real[{}]\n", variables.name(id), fmt::join(variable.array.shape, "]["));
      return;
    }
    const double* const number = std::get_if<double>(&variable.value);
    const std::string value = number != nullptr
                                  ? fmt::format("{:.15g}", *number)
                                  : fmt::format("\"{}\"", std::get<std::string>(variable.value));
    session.print("{} := {}{}\n", variables.name(id), value, variable.parameter ? "  // parameter" : "");
  });
}

void list_procedures(Session& session) {
  for (const auto& [key, procedure] : session.scene().procedures) {
    if (const std::string_view letter = language::letter_of(key); !letter.empty()) {
      session.print("{} :::= {}\n", letter, procedure.source);
    } else if (procedure.parameters.empty() && !procedure.returns_value) {
      session.print("{} := {}\n", procedure.name, procedure.source);
    } else {
      session.print("{} {}({}) {}\n", procedure.returns_value ? "function real" : "procedure", procedure.name,
                    fmt::join(procedure.parameters, ", "), procedure.source);
    }
  }
}

void list_attributes(Session& session) {
  using language::ElementKind;
  for (const ElementKind kind :
       {ElementKind::vertex, ElementKind::edge, ElementKind::facet, ElementKind::body}) {
    std::vector<std::string> names;
    session.names().collect_attributes(kind, names);
    session.print("{}: {}\n", language::name_of(kind), fmt::join(names, ", "));
  }
}

// What stands before, or after, the elements in the scene's datafile.
void list_part(Session& session, bool top) {
  const std::string text = datafile::write_datafile(session.scene());
  const std::size_t elements = text.find("\nvertices");
  const std::size_t read = text.find("\nread\n", elements);
  if (top && elements != std::string::npos) session.write(text.substr(0, elements + 1));
  if (!top && read != std::string::npos) session.write(text.substr(read + 1));
}

void run(Session& session, const ListOptions& options) {
  if (options.elements) {
    session.write(listing(session.attribute_source(), *options.elements));
  } else if (options.what == "variables") {
    list_variables(session);
  } else if (options.what == "procedures") {
    list_procedures(session);
  } else if (options.what == "attributes") {
    list_attributes(session);
  } else if (options.what == "topinfo" || options.what == "bottominfo") {
    list_part(session, options.what == "topinfo");
  } else {
    throw text::Error("list needs to know what",
                      "as in: list vertices where fixed, list facet[3], list variables");
  }
}

}  // namespace

extern const Command list_command = make_command<ListOptions>(
    {.name = "list", .summary = "show elements as lines of a datafile", .group = CommandGroup::output},
    {positional("elements", &ListOptions::elements, "vertices, edges, facets or bodies"),
     positional("what", &ListOptions::what, "what else there is to list")
         .one_of({"variables", "procedures", "attributes", "topinfo", "bottominfo"})},
    run);

}  // namespace lamella::session::commands
