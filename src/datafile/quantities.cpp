#include "datafile/quantities.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "datafile/constraints.h"
#include "datafile/top_section.h"
#include "datafile/top_values.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;
using language::FormulaKind;
using language::Token;
using language::TokenKind;
using scene::Method;
using scene::MethodInstance;
using scene::Quantity;
using scene::QuantityRole;

class QuantityReader {
 public:
  explicit QuantityReader(Reading& reading) : reading_(reading), tokens_(reading.tokens) {}

  void quantity(const Token& word);
  void instance(const Token& word);

 private:
  Token name(const Token& word);
  void role(Quantity& quantity);
  void options(Quantity& quantity);
  bool method(Quantity& quantity);
  MethodInstance method_named(const Token& name);
  void details(MethodInstance& instance);
  void integrand(MethodInstance& instance);
  bool accept(std::string_view word);
  void skip_line_ends();
  double number(std::string_view word);

  Reading& reading_;
  TokenSource& tokens_;
};

void QuantityReader::skip_line_ends() {
  while (tokens_.peek().is(TokenKind::newline)) tokens_.take();
}

// A word that is next, on this line or a later one.
bool QuantityReader::accept(std::string_view word) {
  std::size_t ahead = 0;
  while (tokens_.peek(ahead).is(TokenKind::newline)) ++ahead;
  if (!tokens_.peek(ahead).is_word(word)) return false;
  for (std::size_t i = 0; i <= ahead; ++i) tokens_.take();
  return true;
}

double QuantityReader::number(std::string_view word) {
  if (tokens_.peek().is_symbol("=")) tokens_.take();
  return top_value(reading_, fmt::format("\"{}\" needs a number", word));
}

Token QuantityReader::name(const Token& word) {
  const Token token = tokens_.peek();
  if (!token.is(TokenKind::word)) {
    throw text::Error(token.place, fmt::format("\"{}\" needs a name", text::lower(word.text)));
  }
  if (is_quantity_name(reading_, token.text)) {
    throw text::Error(token.place, fmt::format("there is a quantity \"{}\" already", token.text));
  }
  return tokens_.take();
}

void QuantityReader::role(Quantity& quantity) {
  if (accept("energy")) {
    quantity.role = QuantityRole::energy;
  } else if (accept("info_only") || accept("information_only") || accept("info")) {
    quantity.role = QuantityRole::info_only;
  } else if (accept("conserved")) {
    quantity.role = QuantityRole::conserved;
  } else if (accept("fixed")) {
    quantity.role = QuantityRole::fixed;
    quantity.target = number("fixed");
  } else {
    throw text::Error(tokens_.peek().place, fmt::format("what is the quantity \"{}\" for?", quantity.name),
                      "it is energy, fixed = VALUE, conserved or info_only");
  }
}

void QuantityReader::options(Quantity& quantity) {
  while (true) {
    if (accept("modulus")) {
      quantity.modulus = number("modulus");
    } else if (accept("lagrange_multiplier")) {
      quantity.pressure = number("lagrange_multiplier");
    } else if (accept("tolerance")) {
      number("tolerance");  // volumes and quantities are held as nearly as numbers go
    } else if (accept("volconst")) {
      quantity.constant = number("volconst");
    } else {
      return;
    }
  }
}

MethodInstance QuantityReader::method_named(const Token& name) {
  const std::string key = text::lower(name.text);
  const auto known = std::find_if(reading_.method_instances.begin(), reading_.method_instances.end(),
                                  [&](const MethodInstance& instance) { return instance.name == key; });
  if (known != reading_.method_instances.end()) return *known;
  if (const Method* const method = scene::method_named(key)) {
    MethodInstance instance;
    instance.method = *method;
    return instance;
  }
  reading_.refuse(name.place, name.text, "a method of named quantities");
  throw text::Error(name.place, fmt::format("unknown method \"{}\"", name.text));
}

void QuantityReader::integrand(MethodInstance& instance) {
  const ElementKind element = scene::element_of(instance.method);
  if (accept("scalar_integrand")) {
    const bool general = instance.method == Method::facet_general_integral;
    instance.scalar =
        read_formula(reading_, general ? FormulaKind::space_and_normal : FormulaKind::space, element);
  } else if (accept("vector_integrand")) {
    instance.field = read_components(reading_, "q", FormulaKind::space, element);
  }
}

bool needs_scalar(Method method) {
  return method == Method::vertex_scalar_integral || method == Method::edge_scalar_integral ||
         method == Method::facet_scalar_integral || method == Method::facet_general_integral;
}

bool needs_field(Method method) {
  return method == Method::edge_vector_integral || method == Method::facet_vector_integral;
}

// What may follow the name of a method, up to its integrand.
void QuantityReader::details(MethodInstance& instance) {
  while (true) {
    if (accept("global")) {
      instance.global = true;
    } else if (accept("modulus")) {
      instance.modulus = number("modulus");
    } else if (accept("element_modulus")) {
      instance.element_modulus = text::lower(tokens_.take().text);
    } else {
      break;
    }
  }
  const text::Place here = tokens_.peek().place;
  integrand(instance);
  const bool complete =
      (!needs_scalar(instance.method) || instance.scalar) &&
      (!needs_field(instance.method) || instance.field[0] || instance.field[1] || instance.field[2]);
  if (complete) return;
  throw text::Error(here,
                    fmt::format("the method {} needs its {}", scene::name_of(instance.method),
                                needs_field(instance.method) ? "vector_integrand" : "scalar_integrand"),
                    needs_field(instance.method)
                        ? "write vector_integrand: and lines q1: formula to q3: formula"
                        : "write scalar_integrand: formula");
}

// Takes one method of a quantity, if there is one.
bool QuantityReader::method(Quantity& quantity) {
  const bool everywhere = accept("global_method");
  if (!everywhere && !accept("method")) return false;
  skip_line_ends();
  const Token name = tokens_.take();
  MethodInstance instance = method_named(name);
  instance.global = instance.global || everywhere;
  if (instance.name.empty()) details(instance);
  quantity.methods.push_back(std::move(instance));
  return true;
}

void QuantityReader::quantity(const Token& word) {
  Quantity quantity;
  const Token named = name(word);
  quantity.name = text::lower(named.text);
  if (tokens_.peek().ends_line() && !tokens_.peek(1).is(TokenKind::word)) return;  // only announced
  role(quantity);
  options(quantity);
  // For formulas; whoever sets the target later sets this too.
  if (quantity.role == QuantityRole::fixed) {
    language::Variables& variables = reading_.scene.variables;
    variables.set(variables.id(scene::target_variable(quantity.name)), quantity.target);
  }
  if (accept("function")) {
    reading_.refuse(named.place, "function", "quantities that are functions of others");
    skip_declaration(tokens_);
    return;
  }
  while (method(quantity)) options(quantity);
  if (quantity.methods.empty()) {
    throw text::Error(named.place, fmt::format("the quantity \"{}\" has no method", named.text),
                      "write method facet_scalar_integral, or another");
  }
  reading_.scene.quantities.push_back(std::move(quantity));
}

void QuantityReader::instance(const Token& word) {
  MethodInstance instance;
  const Token named = name(word);
  if (!accept("method")) {
    throw text::Error(tokens_.peek().place, fmt::format("the instance \"{}\" needs its method", named.text),
                      "write method facet_scalar_integral, or another");
  }
  skip_line_ends();
  instance = method_named(tokens_.take());
  instance.name = text::lower(named.text);
  details(instance);
  reading_.method_instances.push_back(std::move(instance));
}

}  // namespace

void read_quantity(Reading& reading, const Token& word) {
  QuantityReader(reading).quantity(word);
}

void read_method_instance(Reading& reading, const Token& word) {
  QuantityReader(reading).instance(word);
}

bool is_quantity_name(const Reading& reading, std::string_view name) {
  const std::string key = text::lower(name);
  const auto named = [&](const auto& one) { return one.name == key; };
  return std::any_of(reading.scene.quantities.begin(), reading.scene.quantities.end(), named) ||
         std::any_of(reading.method_instances.begin(), reading.method_instances.end(), named);
}

namespace {

// An instance that serves several quantities is taken of the same elements for all of them.
void share_instances(Reading& reading) {
  std::set<std::string> everywhere;
  for (const Quantity& quantity : reading.scene.quantities) {
    for (const MethodInstance& instance : quantity.methods) {
      if (!instance.name.empty() && instance.global) everywhere.insert(instance.name);
    }
  }
  for (Quantity& quantity : reading.scene.quantities) {
    for (MethodInstance& instance : quantity.methods) {
      if (everywhere.contains(instance.name)) instance.global = true;
    }
  }
}

// The name itself, and where it is a quantity's, those of its instances.
std::vector<std::string> marks_of(const scene::Scene& scene, const std::string& name) {
  std::vector<std::string> names{name};
  for (const Quantity& quantity : scene.quantities) {
    if (quantity.name != name) continue;
    for (const MethodInstance& instance : quantity.methods) {
      if (!instance.name.empty()) names.push_back(instance.name);
    }
  }
  return names;
}

}  // namespace

void add_memberships(Reading& reading) {
  share_instances(reading);
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    film::Columns& columns = reading.scene.film.columns(kind);
    for (const Membership& member : reading.rows.memberships[static_cast<std::size_t>(kind)]) {
      for (const std::string& mark : marks_of(reading.scene, member.name)) {
        const std::string name = scene::membership_column(mark);
        if (columns.find(name) == nullptr) columns.add(film::integer_column(name));
        columns.edit(name)->set(member.row, 0, 1);
      }
    }
  }
}

}  // namespace lamella::datafile
