// The words that may follow an element in its list, and the columns in which the film keeps them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "film/column.h"

namespace lamella::datafile {

// A column that the datafile gives by a word of its own. Both reader and writer go by this table.
struct KnownColumn {
  enum class Type : std::uint8_t { flag, integer, real };

  film::ElementKind kind = film::ElementKind::vertex;
  std::string_view name;
  Type type = Type::flag;
  double blank = 0;  // what an element has where the datafile says nothing
  film::Inheritance::New on_new = film::Inheritance::New::blank;
};

std::span<const KnownColumn> known_columns();
// Null if there is none.
const KnownColumn* known_column(film::ElementKind kind, std::string_view name);
film::Column make_column(const KnownColumn& known);

// A column that the program makes and that a datafile carries as though the user had declared it.
struct CarriedColumn {
  film::ElementKind kind = film::ElementKind::vertex;
  std::string_view name;
  int width = 1;
  film::Inheritance::New on_new = film::Inheritance::New::blank;
  // Files of earlier versions may have kept only the first so many of its numbers; 0 if they have not.
  int least = 0;
  film::Inheritance::Merge on_merge = film::Inheritance{}.on_merge;
};

// The motion of the vertices, what it remembers of volumes, and the size that the mesh is kept at.
std::span<const CarriedColumn> carried_columns();
const CarriedColumn* carried_column(film::ElementKind kind, std::string_view name);

// The bodies' targets on the move: from, to, begin and end (scene::VolumeRamp). Declared likewise, but no
// column.
inline constexpr std::string_view ramp_name = "volume_ramp";
inline constexpr int ramp_width = 4;

// `define KIND attribute NAME TYPE[...]`
film::Column declared_column(film::ElementKind kind, std::string name, bool integer, std::vector<int> shape);

enum class AttributeAction : std::uint8_t {
  flag,         // sets the column of this name
  number,       // the column's value follows
  whole,        // the same, a whole number
  original,     // the number that the element had in an earlier datafile follows
  both_colors,  // the front's and the back's color follows
  volume,
  pressure,
  density,
  volume_constant,
  actual_volume,
  multiplier,
  constraint,   // numbers or names of constraints follow
  boundary,     // the number or name of a boundary follows
  orientation,  // 1 or -1 follows
  phase,        // the number of a phase follows
  wrap,         // how an edge goes around periods
  nothing,      // a word that a dump file writes and that says nothing
  refused,      // known, but not supported
};

struct AttributeWord {
  std::string_view word;
  std::string_view kinds;  // the first letters of those that have it: vertex, edge, facet, body
  AttributeAction action = AttributeAction::flag;
  std::string_view column;  // or, where refused, what it is about
};

std::span<const AttributeWord> attribute_words();
// Null if this kind of element has no such attribute.
const AttributeWord* attribute_word(film::ElementKind kind, std::string_view word);
// Whether any kind of element has it.
bool is_attribute_word(std::string_view word);
// "edges", "edges and faces"
std::string kinds_with_attribute(std::string_view word);

// As datafiles call them: "vertex", "edge", "face", "body".
std::string_view element_name(film::ElementKind kind);
std::string_view element_plural(film::ElementKind kind);

}  // namespace lamella::datafile
