#include "datafile/element_attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/constraints.h"
#include "datafile/quantities.h"
#include "language/functions.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;
using language::Token;

film::Column* find_column(Reading& reading, ElementKind kind, std::string_view name) {
  std::vector<film::Column>& columns = reading.rows.columns_of(kind);
  const auto at =
      std::find_if(columns.begin(), columns.end(), [&](const auto& column) { return column.name == name; });
  return at == columns.end() ? nullptr : &*at;
}

bool is_declared(Reading& reading, ElementKind kind, std::string_view word) {
  const std::string key = text::lower(word);
  return known_column(kind, key) == nullptr && find_column(reading, kind, key) != nullptr;
}

bool is_any_attribute(Reading& reading, std::string_view word) {
  if (is_attribute_word(word)) return true;
  for (const ElementKind kind :
       {ElementKind::vertex, ElementKind::edge, ElementKind::facet, ElementKind::body}) {
    if (is_declared(reading, kind, word)) return true;
  }
  return false;
}

// As an integer is kept. Throws where it does not fit.
double truncated(const GivenValue& given, RowReader& line) {
  if (std::abs(given.value) > std::numeric_limits<std::int32_t>::max()) {
    throw text::Error(line.place(given.spot), fmt::format("{} is too large for an integer", given.value));
  }
  return std::trunc(given.value);
}

void make_room(film::Column& column, std::uint32_t row) {
  const std::size_t values = std::visit([](const auto& data) { return data.size(); }, column.data);
  if (values <= std::size_t{row} * static_cast<std::size_t>(column.width))
    column.resize(std::size_t{row} + 1);
}

class AttributeReader {
 public:
  AttributeReader(Reading& reading, RowReader& line, ElementKind kind, std::uint32_t row)
      : reading_(reading), line_(line), kind_(kind), row_(row) {}

  void read();

 private:
  BodyRow& body() { return reading_.rows.bodies[row_]; }
  film::Column& column(std::string_view name);
  void set(std::string_view column, double value);
  GivenValue value(const Token& word, std::string_view what = "a number");
  double whole_value(const Token& word);
  void known(const AttributeWord& attribute, const Token& word);
  void original(const Token& word);
  void both_colors(const Token& word);
  void volume(const Token& word);
  void pressure(const Token& word);
  void phase(const Token& word);
  void constraints(const Token& word);
  void boundary(const Token& word);
  void quantity();
  void turn();
  void orientation(const Token& word);
  void wrap(const Token& word);
  void refuse_both(const std::optional<GivenValue>& other, const Token& word);
  void declared(film::Column& column, const Token& word);
  void braced(film::Column& column, const Token& word, std::size_t dimension, int first, int count);

  Reading& reading_;
  RowReader& line_;
  ElementKind kind_;
  std::uint32_t row_;
};

void AttributeReader::read() {
  while (!line_.at_line_end()) {
    if (!line_.at_word()) {
      throw text::Error(line_.place(line_.here()),
                        fmt::format("expected an attribute of {} {}, found {}", element_name(kind_),
                                    reading_.rows.of(kind_).ids[row_], line_.describe_next()));
    }
    // The name of a constraint does without the word before it.
    if (!is_any_attribute(reading_, line_.peek().text) && kind_ != ElementKind::body &&
        declared_constraint(reading_, line_.peek()) != 0) {
      constraints(line_.peek());
      continue;
    }
    if (!is_any_attribute(reading_, line_.peek().text) && is_quantity_name(reading_, line_.peek().text)) {
      quantity();
      continue;
    }
    const Token word = line_.word();
    if (const AttributeWord* attribute = attribute_word(kind_, word.text)) {
      known(*attribute, word);
    } else if (is_declared(reading_, kind_, word.text)) {
      declared(*find_column(reading_, kind_, text::lower(word.text)), word);
    } else {
      refuse_attribute(reading_, kind_, word);
    }
  }
}

// Columns of the language's own attributes are made when the first element has one.
film::Column& AttributeReader::column(std::string_view name) {
  if (film::Column* const existing = find_column(reading_, kind_, name)) return *existing;
  film::Column made = make_column(*known_column(kind_, name));
  if (reading_.scene.strings.on && kind_ == ElementKind::edge && name == "tension") made.blank = 1;
  return reading_.rows.columns_of(kind_).emplace_back(std::move(made));
}

void AttributeReader::set(std::string_view name, double value) {
  film::Column& to = column(name);
  make_room(to, row_);
  to.set(row_, 0, value);
}

GivenValue AttributeReader::value(const Token& word, std::string_view what) {
  if (at_value(reading_, line_)) return line_.value();
  throw text::Error(line_.place(line_.here()), fmt::format("\"{}\" needs {}", word.text, what));
}

double AttributeReader::whole_value(const Token& word) {
  const bool named = line_.at_word();
  const Token name = named ? line_.peek() : Token{};
  try {
    return truncated(value(word), line_);
  } catch (const text::Error& error) {
    if (!named || is_any_attribute(reading_, name.text)) throw;
    std::vector<std::string> colors;
    for (const language::NamedNumber& number : language::named_numbers()) colors.emplace_back(number.name);
    throw text::Error(name.place, fmt::format("unknown color \"{}\"", name.text),
                      text::did_you_mean(name.text, colors));
  }
}

void AttributeReader::known(const AttributeWord& attribute, const Token& word) {
  switch (attribute.action) {
    case AttributeAction::flag:
      return set(attribute.column, 1);
    case AttributeAction::number:
      return set(attribute.column, value(word).value);
    case AttributeAction::whole:
      return set(attribute.column, whole_value(word));
    case AttributeAction::original:
      return original(word);
    case AttributeAction::both_colors:
      return both_colors(word);
    case AttributeAction::volume:
      return volume(word);
    case AttributeAction::pressure:
      return pressure(word);
    case AttributeAction::density:
      body().density = value(word).value;
      return;
    case AttributeAction::phase:
      return phase(word);
    case AttributeAction::volume_constant:
      body().volume_constant = value(word).value;
      return;
    case AttributeAction::actual_volume:
      body().actual_volume = value(word);
      return;
    case AttributeAction::multiplier:
      body().multiplier = value(word).value;
      return;
    case AttributeAction::constraint:
      return constraints(word);
    case AttributeAction::boundary:
      return boundary(word);
    case AttributeAction::orientation:
      return orientation(word);
    case AttributeAction::wrap:
      return wrap(word);
    case AttributeAction::nothing:
      while (line_.at_number()) line_.value();
      return;
    case AttributeAction::refused:
      reading_.refuse(word.place, text::lower(word.text), attribute.column);
      line_.skip_line();
      return;
  }
}

// As a number: six bits for each period, of which five are its wrap in two's complement.
void AttributeReader::wrap(const Token& word) {
  const auto code = static_cast<std::int64_t>(truncated(value(word, "the number of a wrap"), line_));
  if (!reading_.periods)
    throw text::Error(word.place, "only edges of periodic films have wraps", "write torus above");
  film::Wrap result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t bits = (code >> (6 * i)) & 31;
    result.times[i] = static_cast<std::int32_t>(bits < 16 ? bits : bits - 32);
  }
  reading_.rows.edge_wraps.resize(reading_.rows.edge_ends.size());
  reading_.rows.edge_wraps[row_] = result;
}

void AttributeReader::original(const Token& word) {
  const auto number = static_cast<std::int32_t>(truncated(value(word), line_));
  reading_.rows.originals[static_cast<std::size_t>(kind_)].emplace_back(row_, number);
}

void AttributeReader::both_colors(const Token& word) {
  const double color = whole_value(word);
  set("color", color);
  set("backcolor", color);
}

void AttributeReader::volume(const Token& word) {
  refuse_both(body().pressure, word);
  const GivenValue given = value(word);
  if (given.value < 0) {
    throw text::Error(line_.place(given.spot),
                      fmt::format("the volume of a body cannot be negative: {}", given.value));
  }
  body().volume = given;
}

void AttributeReader::pressure(const Token& word) {
  refuse_both(body().volume, word);
  body().pressure = value(word);
}

void AttributeReader::phase(const Token& word) {
  const int number = static_cast<int>(whole_value(word));
  if (kind_ == ElementKind::body) {
    body().phase = number;
    return;
  }
  std::vector<int>& phases = reading_.rows.face_phases;
  if (phases.size() <= row_) phases.resize(row_ + 1, 0);
  phases[row_] = number;
}

void AttributeReader::refuse_both(const std::optional<GivenValue>& other, const Token& word) {
  if (!other) return;
  throw text::Error(word.place, "a body has either a volume or a pressure, not both",
                    "the pressure of a body of given volume is what keeps it there");
}

// --- what holds an element

void AttributeReader::constraints(const Token& word) {
  std::vector<std::pair<std::uint32_t, int>>& held =
      reading_.rows.constraints[static_cast<std::size_t>(kind_)];
  const std::size_t before = held.size();
  while (!line_.at_line_end()) {
    const bool negative = line_.accept("-");
    const Token token = line_.peek();
    const bool named =
        token.is(language::TokenKind::word) && reading_.constraint_names.contains(text::lower(token.text));
    if (!token.is(language::TokenKind::number) && !named) {
      if (negative)
        throw text::Error(token.place, fmt::format("expected a constraint, found {}", describe(token)));
      break;
    }
    line_.word();
    const int number = declared_constraint(reading_, token);
    if (number == 0) {
      throw text::Error(token.place, fmt::format("there is no constraint {}", token.text),
                        "constraints are declared before the lists: constraint 1, and formula: z = 0");
    }
    held.emplace_back(row_, number);
    if (negative && kind_ == ElementKind::edge) turn();
  }
  if (held.size() == before) {
    throw text::Error(word.place, fmt::format("\"{}\" needs the number or name of a constraint", word.text));
  }
}

void AttributeReader::boundary(const Token& word) {
  const Token token = line_.at_line_end() ? word : line_.word();
  const int number = declared_boundary(reading_, token);
  if (number == 0) {
    throw text::Error(token.place, fmt::format("there is no boundary {}", token.text),
                      "boundaries are declared before the lists: boundary 1 parameters 1, and x1: cos(p1)");
  }
  const int wanted = reading_.scene.boundaries.at(number).parameters;
  if (kind_ == ElementKind::vertex && reading_.rows.coordinates != wanted) {
    throw text::Error(word.place,
                      fmt::format("a vertex on boundary {} is given by {} parameter{}, not by {} numbers",
                                  token.text, wanted, wanted == 1 ? "" : "s", reading_.rows.coordinates));
  }
  reading_.rows.boundaries[static_cast<std::size_t>(kind_)].emplace_back(row_, number);
}

void AttributeReader::quantity() {
  const Token name = line_.word();
  reading_.rows.memberships[static_cast<std::size_t>(kind_)].push_back({row_, text::lower(name.text)});
}

void AttributeReader::turn() {
  set("orientation", -1);
  if (kind_ == ElementKind::edge) reading_.rows.turned_edges.push_back(row_);
}

void AttributeReader::orientation(const Token& word) {
  if (value(word).value < 0) turn();
}

// --- attributes of the user

void AttributeReader::declared(film::Column& column, const Token& word) {
  make_room(column, row_);
  column.blank_row(row_);
  if (!line_.at_line_end() && !line_.at_number() && line_.accept("{")) {
    braced(column, word, 0, 0, column.width);
    return;
  }
  const std::string what =
      column.width == 1 ? std::string("a value") : fmt::format("{} values", column.width);
  const bool integer = std::holds_alternative<film::Integers>(column.data);
  for (int i = 0; i < column.width; ++i) {
    const GivenValue given = value(word, what);
    column.set(row_, i, integer ? truncated(given, line_) : given.value);
  }
}

// After an opening brace: `count` values from `first`, in further braces where there are more dimensions.
// Those left out are zero.
void AttributeReader::braced(film::Column& column, const Token& word, std::size_t dimension, int first,
                             int count) {
  line_.begin_braces();
  const int parts = dimension < column.shape.size() ? column.shape[dimension] : 1;
  const int part_size = count / parts;
  const bool integer = std::holds_alternative<film::Integers>(column.data);
  for (int part = 0; !line_.accept("}"); ++part) {
    const Spot spot = line_.here();
    if (line_.at_line_end()) {
      throw text::Error(line_.place(spot),
                        fmt::format("the values of \"{}\" are never closed: missing \"}}\"", word.text));
    }
    if (part == parts) {
      throw text::Error(line_.place(spot),
                        fmt::format("too many values for \"{}\": it takes {}", word.text, parts));
    }
    const int at = first + part * part_size;
    if (line_.accept("{")) {
      if (part_size == 1 && dimension + 1 >= column.shape.size()) {
        throw text::Error(line_.place(spot), fmt::format("\"{}\" has no further dimension", word.text));
      }
      braced(column, word, dimension + 1, at, part_size);
    } else {
      const GivenValue given = value(word, "a value or a \"}\"");
      column.set(row_, at, integer ? truncated(given, line_) : given.value);
    }
  }
}

}  // namespace

bool at_value(Reading& reading, RowReader& line) {
  if (line.at_line_end()) return false;
  if (line.at_number()) return true;
  return line.at_word() && !is_any_attribute(reading, line.peek().text);
}

bool begins_attribute(Reading& reading, ElementKind kind, std::string_view word) {
  return attribute_word(kind, word) != nullptr || is_declared(reading, kind, word);
}

void refuse_attribute(Reading& reading, ElementKind kind, const Token& word) {
  if (is_attribute_word(word.text)) {
    throw text::Error(word.place, fmt::format("\"{}\" is an attribute of {}, not of {}", word.text,
                                              kinds_with_attribute(word.text), element_plural(kind)));
  }
  std::vector<std::string> known;
  for (const AttributeWord& attribute : attribute_words()) {
    if (attribute_word(kind, attribute.word) != nullptr) known.emplace_back(attribute.word);
  }
  for (const film::Column& column : reading.rows.columns_of(kind)) known.push_back(column.name);
  for (const ElementKind other :
       {ElementKind::vertex, ElementKind::edge, ElementKind::facet, ElementKind::body}) {
    if (!is_declared(reading, other, word.text)) continue;
    throw text::Error(word.place, fmt::format("\"{}\" is declared as an attribute of {}, not of {}",
                                              word.text, element_plural(other), element_plural(kind)));
  }
  std::string hint = text::did_you_mean(word.text, known);
  if (hint.empty()) {
    hint = fmt::format("an attribute of one's own is declared before the lists: define {} attribute {} real",
                       film::name_of(kind), word.text);
  }
  throw text::Error(word.place, fmt::format("{} have no attribute \"{}\"", element_plural(kind), word.text),
                    hint);
}

void read_attributes(Reading& reading, RowReader& line, ElementKind kind, std::uint32_t row) {
  AttributeReader(reading, line, kind, row).read();
}

}  // namespace lamella::datafile
