// PLY, in all three of its encodings: vertices, faces (with regions, where an export wrote them) and edges.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "exchange/soup.h"
#include "exchange/words.h"

namespace lamella::exchange {

namespace {

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding : std::uint8_t { text, little, big };

std::optional<Type> type_named(std::string_view name) {
  static const std::map<std::string_view, Type> names = {
      {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
      {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
      {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
      {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
      {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
      {"float64", Type::float64}};
  const auto at = names.find(name);
  return at == names.end() ? std::nullopt : std::optional(at->second);
}

std::size_t bytes_of(Type type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type = Type::float64;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;

  // Its place among the properties; nothing where there is none.
  std::optional<std::size_t> find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (properties[i].name == property) return i;
    }
    return std::nullopt;
  }
};

// The values of one row, a list for each property.
using Row = std::vector<std::vector<double>>;

// Rows from text or bytes.
class RowSource {
 public:
  RowSource(WordReader& lines, Encoding encoding, std::string path)
      : lines_(lines), encoding_(encoding), path_(std::move(path)), bytes_(lines.rest()) {}

  void read(const Element& element, long number, Row& row) {
    row.resize(element.properties.size());
    if (encoding_ == Encoding::text && !lines_.next_line())
      lines_.fail_at_end(fmt::format("{} {} of {} is missing", element.name, number, element.count));
    word_ = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Property& property = element.properties[i];
      std::size_t count = 1;
      row[i].clear();
      if (property.count_type) {
        const double given = value(element, number, *property.count_type);
        constexpr double most = 1e6;
        if (!(given >= 0 && given <= most)) fail(element, number, fmt::format("has a list of {}", given));
        count = static_cast<std::size_t>(given);
      }
      for (std::size_t k = 0; k < count; ++k) row[i].push_back(value(element, number, property.type));
    }
  }

  // What is wrong with the row read last.
  [[noreturn]] void fail(const Element& element, long number, const std::string& what) const {
    const std::string message = fmt::format("{} {} {}", element.name, number, what);
    if (encoding_ == Encoding::text) lines_.fail(0, message);
    throw text::Error(fmt::format("\"{}\": {}", path_, message));
  }

 private:
  double value(const Element& element, long number, Type type) {
    if (encoding_ == Encoding::text) return lines_.number(word_++, "a value");
    const std::size_t size = bytes_of(type);
    if (at_ + size > bytes_.size()) {
      throw text::Error(
          fmt::format("\"{}\" ends within {} {} of {}", path_, element.name, number + 1, element.count));
    }
    char block[8];
    for (std::size_t i = 0; i < size; ++i)
      block[i] = bytes_[at_ + (encoding_ == Encoding::big ? size - 1 - i : i)];
    at_ += size;
    return decoded(block, type);
  }

  template <class Number>
  static double as(const char* block) {
    Number number;
    std::memcpy(&number, block, sizeof number);
    return static_cast<double>(number);
  }
  static double decoded(const char* block, Type type) {
    switch (type) {
      case Type::int8:
        return as<std::int8_t>(block);
      case Type::uint8:
        return as<std::uint8_t>(block);
      case Type::int16:
        return as<std::int16_t>(block);
      case Type::uint16:
        return as<std::uint16_t>(block);
      case Type::int32:
        return as<std::int32_t>(block);
      case Type::uint32:
        return as<std::uint32_t>(block);
      case Type::float32:
        return as<float>(block);
      case Type::float64:
        return as<double>(block);
    }
    return 0;
  }

  WordReader& lines_;
  Encoding encoding_;
  std::string path_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t word_ = 0;
};

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string content)
      : path_(path), lines_(path, std::move(content), '\0') {}

  Soup read() {
    header();
    RowSource rows(lines_, encoding_, path_);
    Row row;
    for (const Element& element : elements_) {
      const auto read_row = reader_of(element);
      for (long i = 0; i < element.count; ++i) {
        rows.read(element, i, row);
        if (read_row) read_row(rows, i, row);
      }
    }
    return std::move(soup_);
  }

 private:
  using RowReader = std::function<void(const RowSource&, long, const Row&)>;

  void header() {
    if (!lines_.next_line() || lines_.word(0) != "ply") lines_.fail(0, "a PLY file begins with the word ply");
    while (true) {
      if (!lines_.next_line()) lines_.fail_at_end("the header has no end_header");
      const std::string_view word = lines_.word(0);
      if (word == "end_header") return;
      if (word == "format") {
        format();
      } else if (word == "element") {
        if (lines_.count() < 3) lines_.fail(lines_.count(), "an element has a name and a count");
        const long count = lines_.whole(2, "the count");
        if (count < 0) lines_.fail(2, fmt::format("there cannot be {} elements", count));
        elements_.push_back({std::string(lines_.word(1)), count, {}});
      } else if (word == "property") {
        property();
      } else if (word != "comment" && word != "obj_info") {
        lines_.fail(0, fmt::format("\"{}\" is no word of a PLY file's header", word));
      }
    }
  }

  void format() {
    const std::string_view name = lines_.count() > 1 ? lines_.word(1) : std::string_view{};
    if (name == "ascii") {
      encoding_ = Encoding::text;
    } else if (name == "binary_little_endian") {
      encoding_ = Encoding::little;
    } else if (name == "binary_big_endian") {
      encoding_ = Encoding::big;
    } else {
      lines_.fail(1, "the format is ascii, binary_little_endian or binary_big_endian");
    }
  }

  Type type(std::size_t i) const {
    if (i >= lines_.count()) lines_.fail(i, "the line ends before the property's type");
    const std::optional<Type> known = type_named(lines_.word(i));
    if (!known) lines_.fail(i, fmt::format("\"{}\" is no type of a property", lines_.word(i)));
    return *known;
  }

  void property() {
    if (elements_.empty()) lines_.fail(0, "a property comes after its element");
    Property made;
    const bool list = lines_.count() > 1 && lines_.word(1) == "list";
    if (list) made.count_type = type(2);
    made.type = type(list ? 3 : 1);
    const std::size_t name = list ? 4 : 2;
    if (lines_.count() <= name) lines_.fail(name, "the property has no name");
    made.name = std::string(lines_.word(name));
    elements_.back().properties.push_back(std::move(made));
  }

  std::size_t needed(const Element& element, std::string_view property) const {
    const auto at = element.find(property);
    if (!at) throw text::Error(fmt::format("\"{}\": {} has no property {}", path_, element.name, property));
    return *at;
  }

  RowReader reader_of(const Element& element) {
    if (element.name == "vertex") return vertex_reader(element);
    if (element.name == "face") return face_reader(element);
    if (element.name == "edge") return edge_reader(element);
    return {};
  }

  RowReader vertex_reader(const Element& element) {
    const std::array<std::size_t, 3> axes = {needed(element, "x"), needed(element, "y"),
                                             needed(element, "z")};
    return [this, axes, &element](const RowSource& rows, long number, const Row& row) {
      for (const std::size_t axis : axes) {
        if (row[axis].size() != 1 || !std::isfinite(row[axis][0]))
          rows.fail(element, number, "is at no place");
      }
      soup_.points.push_back({row[axes[0]][0], row[axes[1]][0], row[axes[2]][0]});
    };
  }

  std::uint32_t vertex(const RowSource& rows, const Element& element, long number, double value) const {
    if (!(value >= 0 && value < static_cast<double>(soup_.points.size()) && value == std::floor(value)))
      rows.fail(element, number,
                fmt::format("names vertex {}, and there are {}", value, soup_.points.size()));
    return static_cast<std::uint32_t>(value);
  }

  RowReader face_reader(const Element& element) {
    const std::size_t corners =
        element.find("vertex_indices") ? *element.find("vertex_indices") : needed(element, "vertex_index");
    const auto front = element.find("front");
    const auto behind = element.find("behind");
    return [=, this, &element](const RowSource& rows, long number, const Row& row) {
      if (row[corners].size() < 3) rows.fail(element, number, "has fewer than three corners");
      std::vector<std::uint32_t> polygon;
      for (const double v : row[corners]) polygon.push_back(vertex(rows, element, number, v));
      soup_.add_polygon(polygon);
      if (!front || !behind) return;
      const auto region = [&](std::size_t i) {
        if (row[i].size() != 1 || !(row[i][0] >= 0 && row[i][0] < 4e9))
          rows.fail(element, number, "has a region that is no number of one");
        return film::Region{static_cast<std::uint32_t>(row[i][0])};
      };
      soup_.regions.push_back({region(*front), region(*behind)});
    };
  }

  RowReader edge_reader(const Element& element) {
    const std::size_t first = needed(element, "vertex1");
    const std::size_t second = needed(element, "vertex2");
    const auto kind = element.find("kind");
    return [=, this, &element](const RowSource& rows, long number, const Row& row) {
      constexpr double wire = 3;
      if (row[first].size() != 1 || row[second].size() != 1) rows.fail(element, number, "has no two ends");
      soup_.wires.push_back(
          {vertex(rows, element, number, row[first][0]), vertex(rows, element, number, row[second][0])});
      const bool known = kind && row[*kind].size() == 1 && row[*kind][0] != wire;
      soup_.wire_kinds.push_back(known ? WireKind::line : WireKind::wire);
    };
  }

  std::string path_;
  WordReader lines_;
  Encoding encoding_ = Encoding::text;
  std::vector<Element> elements_;
  Soup soup_;
};

}  // namespace

Soup read_ply(const std::string& path, std::string content) {
  return PlyReader(path, std::move(content)).read();
}

}  // namespace lamella::exchange
