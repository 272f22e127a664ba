#include "datafile/elements.h"

#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/element_attributes.h"
#include "datafile/keywords.h"
#include "datafile/row_reader.h"
#include "text/suggest.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;
using language::Token;

constexpr double largest_coordinate = 1e100;

std::string_view text_at(const text::Place& place) {
  return std::string_view(place.source->content).substr(place.offset, place.length);
}

class ListReader {
 public:
  explicit ListReader(Reading& reading) : reading_(reading), line_(reading.tokens, reading.scene.variables) {}

  bool read();

 private:
  Rows& rows() { return reading_.rows; }
  int dimension() const { return reading_.scene.strings.dimension; }  // of space
  std::vector<std::uint8_t>& broken(ElementKind kind) {
    return rows().broken[static_cast<std::size_t>(kind)];
  }

  void word_line();
  void more_attributes(const Token& word);
  void begin_section(Section section, const Token& word);
  void report_missing_sections(Section section, const Token& word);
  void unknown_word(const Token& word);
  void element();
  std::optional<std::uint32_t> element_number();
  void definition();
  void coordinates();
  [[noreturn]] void refuse_coordinates();
  void check_coordinates();
  void ends();
  void wrap();
  void signed_list(SignedLists& lists, std::string_view what, std::string_view wanted);
  std::uint32_t reference(std::string_view what);
  void close_list(SignedLists& lists) {
    lists.begins.push_back(static_cast<std::uint32_t>(lists.ids.size()));
  }

  Reading& reading_;
  RowReader line_;
  std::optional<Section> section_;
  ElementKind kind_ = ElementKind::vertex;
  std::optional<std::uint32_t> row_;  // of the last element in this list
  Spot end_of_coordinates_;           // of the last vertex
  bool at_read_ = false;
};

bool ListReader::read() {
  bool at_end = false;
  while (!at_end && !at_read_ && !reading_.findings.too_many()) {
    reading_.attempt(
        [&] {
          line_.begin_line();
          if (line_.at_file_end()) {
            at_end = true;
          } else if (line_.at_word()) {
            word_line();
          } else {
            element();
          }
        },
        [&] { line_.skip_line(); });
  }
  return at_read_;
}

// --- lines that begin with a word

void ListReader::word_line() {
  const Token word = line_.peek();
  if (const auto section = section_named(word.text)) {
    line_.word();
    begin_section(*section, word);
  } else if (section_ && begins_attribute(reading_, kind_, word.text)) {
    more_attributes(word);
  } else {
    unknown_word(word);
  }
}

// They belong to the element before them.
void ListReader::more_attributes(const Token& word) {
  if (!row_) {
    throw text::Error(word.place,
                      fmt::format("\"{}\" stands before the first {}", word.text, element_name(kind_)));
  }
  read_attributes(reading_, line_, kind_, *row_);
}

// A misspelt section is taken for what it was meant to be, or all its lines would be mistakes.
void ListReader::unknown_word(const Token& word) {
  std::vector<std::string> sections;
  collect_sections(sections);
  const std::optional<std::string> meant = text::closest(word.text, sections);
  line_.word();
  if (meant) {
    reading_.findings.error(word.place, fmt::format("unknown word \"{}\"", word.text),
                            text::did_you_mean(word.text, sections));
    begin_section(*section_named(*meant), word);
    rows().of(kind_).incomplete = true;
    return;
  }
  if (section_) refuse_attribute(reading_, kind_, word);
  throw text::Error(word.place, fmt::format("unknown word \"{}\"", word.text));
}

void ListReader::begin_section(Section section, const Token& word) {
  if (section == Section::read) {
    at_read_ = true;
    return;
  }
  report_missing_sections(section, word);
  if (section_ && section <= *section_) {
    const bool twice = section == *section_;
    reading_.findings.error(
        word.place,
        twice ? fmt::format("the list of {} begins twice", name_of(section))
              : fmt::format("the list of {} stands after that of {}", name_of(section), name_of(*section_)),
        "the order is vertices, edges, faces, bodies");
  }
  section_ = section;
  kind_ = static_cast<ElementKind>(section);
  row_.reset();
}

void ListReader::report_missing_sections(Section section, const Token& word) {
  const int first = section_ ? static_cast<int>(*section_) + 1 : 0;
  for (int i = first; i < static_cast<int>(section); ++i) {
    const auto missing = static_cast<Section>(i);
    rows().of(static_cast<ElementKind>(i)).incomplete = true;
    if (i > first) continue;  // one of them is enough to say
    reading_.findings.error(
        word.place,
        fmt::format("the list of {} is missing before that of {}", name_of(missing), name_of(section)),
        "the order is vertices, edges, faces, bodies");
  }
}

// --- elements

void ListReader::element() {
  if (!section_) {
    const Token token = line_.peek();
    throw text::Error(token.place,
                      fmt::format("expected a keyword such as vertices, found {}", describe(token)));
  }
  Numbering& numbering = rows().of(kind_);
  const Spot spot = line_.here();
  const std::optional<std::uint32_t> id = element_number();
  if (!id) {
    numbering.incomplete = true;
    line_.skip_line();
    return;
  }
  const auto row = static_cast<std::uint32_t>(numbering.size());
  row_ = row;
  numbering.ids.push_back(*id);
  numbering.spots.push_back(spot);
  broken(kind_).push_back(1);  // until it has been read to its end
  definition();
  if (!line_.at_line_end()) read_attributes(reading_, line_, kind_, row);
  check_coordinates();
  broken(kind_)[row] = 0;
}

// Nothing where it is unusable; then that has been reported.
std::optional<std::uint32_t> ListReader::element_number() {
  const std::string_view name = element_name(kind_);
  std::optional<std::uint32_t> result;
  reading_.attempt(
      [&] {
        const GivenValue given = line_.whole();
        const text::Place place = line_.place(given.spot);
        if (given.value < 1) {
          throw text::Error(place,
                            fmt::format("the number of a {} must be positive, not {}", name, given.value));
        }
        if (given.value > static_cast<double>(largest_id)) {
          throw text::Error(place, fmt::format("the number {:.0f} is too large", given.value),
                            fmt::format("numbers of elements go up to {}", largest_id));
        }
        result = static_cast<std::uint32_t>(given.value);
      },
      [] {});
  return result;
}

void ListReader::definition() {
  switch (kind_) {
    case ElementKind::vertex:
      coordinates();
      break;
    case ElementKind::edge:
      ends();
      break;
    case ElementKind::facet:
      signed_list(rows().loops, "edge", "edges");
      break;
    case ElementKind::body:
      rows().bodies.emplace_back();
      signed_list(rows().body_faces, "face", "faces");
      break;
  }
}

constexpr std::array<std::string_view, 3> few = {"no coordinates", "one coordinate", "two coordinates"};

// A vertex on a boundary is given by its parameters; whether it lies on one, its attributes tell.
void ListReader::coordinates() {
  const std::uint32_t id = rows().of(ElementKind::vertex).ids.back();
  rows().positions.emplace_back();
  rows().coordinates = 0;
  film::Vec3 position;
  while (rows().coordinates < dimension() && at_value(reading_, line_)) {
    const GivenValue given = line_.value();
    if (std::abs(given.value) > largest_coordinate) {
      throw text::Error(line_.place(given.spot),
                        fmt::format("the coordinate {} is too large", text_at(line_.place(given.spot))),
                        fmt::format("coordinates go up to {}", largest_coordinate));
    }
    position[rows().coordinates++] = given.value;
  }
  end_of_coordinates_ = line_.here();
  const bool may_be_parameters = rows().coordinates > 0 && !reading_.scene.boundaries.empty();
  if (rows().coordinates < dimension() && !may_be_parameters) refuse_coordinates();
  if (line_.at_number()) {
    const text::Place place = line_.place(line_.here());
    const bool commas = text::line_of(place).find(',') != std::string_view::npos;
    throw text::Error(
        place, fmt::format("vertex {} has more than {} coordinates", id, dimension() == 2 ? "two" : "three"),
        commas ? "commas stand between numbers; decimals have a point" : "");
  }
  rows().positions.back() = position;
}

void ListReader::refuse_coordinates() {
  throw text::Error(
      line_.place(end_of_coordinates_),
      fmt::format("vertex {} has {}, and needs {}", rows().of(ElementKind::vertex).ids.back(),
                  few[static_cast<std::size_t>(rows().coordinates)], dimension() == 2 ? "two" : "three"));
}

// After the attributes of a vertex.
void ListReader::check_coordinates() {
  if (kind_ != ElementKind::vertex || rows().coordinates == dimension()) return;
  const auto& boundaries = rows().boundaries[static_cast<std::size_t>(ElementKind::vertex)];
  if (boundaries.empty() || boundaries.back().first != *row_) refuse_coordinates();
}

// The number of an element that is referred to, without a sign; 0 is refused later, where everything that is
// not defined is.
std::uint32_t ListReader::reference(std::string_view what) {
  const GivenValue given = line_.whole();
  if (given.value < 0 || given.value > static_cast<double>(largest_id)) {
    throw text::Error(line_.place(given.spot), fmt::format("{} {:.0f} is not defined", what, given.value));
  }
  return static_cast<std::uint32_t>(given.value);
}

void ListReader::ends() {
  const std::uint32_t id = rows().of(ElementKind::edge).ids.back();
  rows().edge_ends.push_back({0, 0});
  rows().edge_end_spots.emplace_back();
  std::array<std::uint32_t, 2> ends{};
  for (std::size_t end = 0; end < 2; ++end) {
    const Spot spot = line_.here();
    if (line_.at_line_end() || !line_.at_whole()) {
      throw text::Error(line_.place(spot), fmt::format("edge {} needs two vertices", id));
    }
    ends[end] = reference("vertex");
    rows().edge_end_spots.back()[end] = spot;
  }
  if (reading_.periods && !reading_.wraps_are_attributes) wrap();
  if (!line_.at_line_end() && line_.at_whole()) {
    throw text::Error(line_.place(line_.here()), fmt::format("edge {} has more than two vertices", id));
  }
  rows().edge_ends.back() = ends;
}

// Three signs: how the edge goes around each period.
void ListReader::wrap() {
  film::Wrap wrap;
  for (std::int32_t& times : std::span(wrap.times).first(static_cast<std::size_t>(dimension()))) {
    if (line_.accept("+")) {
      times = 1;
    } else if (line_.accept("-")) {
      times = -1;
    } else if (!line_.accept("*")) {
      throw text::Error(line_.place(line_.here()),
                        fmt::format("edge {} needs a sign for each period, for how it goes around",
                                    rows().of(ElementKind::edge).ids.back()),
                        "+ for once around, - for once backward, * for not at all: 1  4 7  * + *");
    }
  }
  rows().edge_wraps.resize(rows().edge_ends.size());
  rows().edge_wraps.back() = wrap;
}

void ListReader::signed_list(SignedLists& lists, std::string_view what, std::string_view wanted) {
  const std::size_t begin = lists.ids.size();
  close_list(lists);
  while (!line_.at_line_end() && line_.at_whole()) {
    const GivenValue given = line_.whole();
    if (std::abs(given.value) > static_cast<double>(largest_id)) {
      throw text::Error(line_.place(given.spot),
                        fmt::format("{} {:.0f} is not defined", what, std::abs(given.value)));
    }
    lists.ids.push_back(static_cast<std::int32_t>(given.value));
    lists.spots.push_back(given.spot);
    ++lists.begins.back();
  }
  if (lists.ids.size() > begin) return;
  const Numbering& numbering = rows().of(kind_);
  throw text::Error(line_.place(numbering.spots.back()),
                    fmt::format("{} {} has no {}", element_name(kind_), numbering.ids.back(), wanted));
}

}  // namespace

bool read_lists(Reading& reading) {
  return ListReader(reading).read();
}

}  // namespace lamella::datafile
