// What a command takes, as a table: the same table parses a line, checks it, completes it on Tab and prints
// the usage.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "language/elements.h"
#include "language/expression.h"
#include "language/statement.h"
#include "scene/forces.h"
#include "text/source.h"

namespace lamella::session {

// --- kinds of values that an option may have, besides double, long, bool, std::string and std::array<double,
// n>; std::optional of any of them tells whether it was given.

// A path: a quoted string, a string variable or a bare word such as ../out-2.png.
struct File {
  std::string path;
  text::Place place;
};

// A bare word.
struct Word {
  std::string text;
  text::Place place;
};

// Elements picked out: `vertices where x > 1`, `edge[5]`, `facet[2].edge`. In the order of their rows.
struct Elements {
  language::ElementKind kind = language::ElementKind::vertex;
  std::vector<language::Element> list;
};

// Elements not yet picked out.
struct Selection {
  const language::Generator* generator = nullptr;
  std::string text;  // as typed
};

// `(elements, value)`: what to take of each of some elements.
struct Sample {
  const language::Generator* generator = nullptr;
  const language::Expression* value = nullptr;
};

// Expressions not yet evaluated, separated by commas.
struct Expressions {
  std::vector<const language::Expression*> list;
};

// `vertex x x+1 where id < 5`: elements, one of their attributes, and its new value (null: none is given).
struct Setting {
  const language::Generator* generator = nullptr;
  const language::AttributeUse* attribute = nullptr;
  const language::Expression* value = nullptr;
  text::Place place;  // of the attribute's name
};

// `width real`, `vertex attribute heat real[3]`
struct Definition {
  std::string name;
  std::string type;  // real, integer or string
  std::optional<language::ElementKind> attribute_of;
  std::vector<const language::Expression*> sizes;
  text::Place place;  // of the name
};

// The text of a procedure, by its name.
struct ProcedureName {
  std::string name;
};

// A number of each element, not yet evaluated: `color=length`. Of edges, vertices or facets, whichever have
// the attributes that it names; the argument's `first_kind` where any would do; those named first in
// `color=vertex z`.
struct Field {
  language::ElementKind kind = language::ElementKind::facet;
  language::LocalId slot;  // where the element in turn is put
  const language::Expression* value = nullptr;
  std::string text;  // as typed
};

// Commands in braces, with local names of their own.
struct Commands {
  std::shared_ptr<const language::Block> block;
};

// Three formulas of a vertex, as in (0, -z, vx): see scene/forces.h.
struct VertexFormulas {
  scene::VectorFormula formula;
};

// What `print` may be given.
using Printable = std::variant<ProcedureName, const language::Expression*>;

// --- the table

enum class ArgumentKind : std::uint8_t {
  number,
  count,  // a whole number
  text,
  file,
  word,
  flag,
  numbers,  // as many as there are, separated by commas: (1, 0, 0)
  elements,
  selection,
  expressions,
  setting,
  definition,
  printable,
  field,
  commands,
  formulas,
  sample,
};

// The value of an argument, as it reaches the options.
using GivenValue =
    std::variant<double, long, std::string, File, Word, bool, std::vector<double>, Elements, Selection,
                 Expressions, Setting, Definition, Printable, Field, Commands, VertexFormulas, Sample>;

struct Argument {
  std::string name;
  std::string help;
  ArgumentKind kind = ArgumentKind::number;
  bool named = false;  // its name is typed before the value, or alone if a flag
  bool needed = false;
  std::vector<std::string> choices;  // of a text: the only words it may be
  std::string word_for_none;         // a word that leaves the option unset, such as `auto`
  std::optional<double> least;       // bounds of numbers
  bool least_excluded = false;
  std::optional<double> most;
  std::size_t how_many = 1;  // of numbers
  language::ElementKind first_kind =
      language::ElementKind::facet;  // what a field is of where it may be of any
  std::function<void(void* options, const GivenValue& value)> store;
};

namespace detail {

template <class T>
struct Unwrapped {
  using Type = T;
};
template <class T>
struct Unwrapped<std::optional<T>> {
  using Type = T;
};

// How a member of an options struct is filled: the kind of argument, and the conversion from what was given.
template <class T>
struct Filled;

template <ArgumentKind argument_kind, class T>
struct FilledAs {
  static constexpr ArgumentKind kind = argument_kind;
  static constexpr std::size_t how_many = 1;
  static T from(const GivenValue& value) { return std::get<T>(value); }
};

template <>
struct Filled<double> : FilledAs<ArgumentKind::number, double> {};
template <>
struct Filled<long> : FilledAs<ArgumentKind::count, long> {};
template <>
struct Filled<int> : FilledAs<ArgumentKind::count, int> {
  static int from(const GivenValue& value) { return static_cast<int>(std::get<long>(value)); }
};
template <>
struct Filled<std::string> : FilledAs<ArgumentKind::text, std::string> {};
template <>
struct Filled<bool> : FilledAs<ArgumentKind::flag, bool> {};
template <>
struct Filled<File> : FilledAs<ArgumentKind::file, File> {};
template <>
struct Filled<Word> : FilledAs<ArgumentKind::word, Word> {};
template <>
struct Filled<Elements> : FilledAs<ArgumentKind::elements, Elements> {};
template <>
struct Filled<Selection> : FilledAs<ArgumentKind::selection, Selection> {};
template <>
struct Filled<Expressions> : FilledAs<ArgumentKind::expressions, Expressions> {};
template <>
struct Filled<Setting> : FilledAs<ArgumentKind::setting, Setting> {};
template <>
struct Filled<Definition> : FilledAs<ArgumentKind::definition, Definition> {};
template <>
struct Filled<Printable> : FilledAs<ArgumentKind::printable, Printable> {};
template <>
struct Filled<Field> : FilledAs<ArgumentKind::field, Field> {};
template <>
struct Filled<Commands> : FilledAs<ArgumentKind::commands, Commands> {};
template <>
struct Filled<VertexFormulas> : FilledAs<ArgumentKind::formulas, VertexFormulas> {};
template <>
struct Filled<Sample> : FilledAs<ArgumentKind::sample, Sample> {};
template <std::size_t n>
struct Filled<std::array<double, n>> {
  static constexpr ArgumentKind kind = ArgumentKind::numbers;
  static constexpr std::size_t how_many = n;
  static std::array<double, n> from(const GivenValue& value) {
    std::array<double, n> result{};
    const auto& given = std::get<std::vector<double>>(value);
    for (std::size_t i = 0; i < n; ++i) result[i] = given[i];
    return result;
  }
};

}  // namespace detail

// An argument of a command with these options; the calls refine it, as in positional(...).at_least(1).
template <class Options>
struct ArgumentOf : Argument {
  ArgumentOf required() && { return needed = true, std::move(*this); }
  ArgumentOf at_least(double bound) && { return least = bound, std::move(*this); }
  ArgumentOf above(double bound) && { return least = bound, least_excluded = true, std::move(*this); }
  ArgumentOf at_most(double bound) && { return most = bound, std::move(*this); }
  ArgumentOf one_of(std::vector<std::string> words) && {
    return choices = std::move(words), std::move(*this);
  }
  ArgumentOf of(language::ElementKind first) && { return first_kind = first, std::move(*this); }
  ArgumentOf or_word(std::string word) && { return word_for_none = std::move(word), std::move(*this); }
};

// A value at its place in the line: `evolve 100`. A positional argument that is not required may be left out;
// the next one is tried with what is typed (`refine 2`, `refine edges where ...`).
template <class Options, class T>
ArgumentOf<Options> positional(std::string name, T Options::*member, std::string help) {
  using Member = detail::Filled<typename detail::Unwrapped<T>::Type>;
  ArgumentOf<Options> result;
  result.name = std::move(name);
  result.help = std::move(help);
  result.kind = Member::kind;
  result.how_many = Member::how_many;
  result.store = [member](void* options, const GivenValue& value) {
    static_cast<Options*>(options)->*member = Member::from(value);
  };
  return result;
}

// A value after its name, anywhere in the line: `dt 0.01` or `dt=0.01`.
template <class Options, class T>
ArgumentOf<Options> option(std::string name, T Options::*member, std::string help) {
  ArgumentOf<Options> result = positional(std::move(name), member, std::move(help));
  result.named = true;
  return result;
}

// A word that is there or not.
template <class Options>
ArgumentOf<Options> flag(std::string name, bool Options::*member, std::string help) {
  return option(std::move(name), member, std::move(help));
}

}  // namespace lamella::session
