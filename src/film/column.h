// Data that travels with the mesh: one row of `width` values for each element of a kind.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "film/shared.h"

namespace lamella::film {

enum class ElementKind : std::uint8_t { vertex, edge, facet, body };

std::string_view name_of(ElementKind kind);

// What a new element gets, and what is left when two become one.
struct Inheritance {
  // A vertex that splits an edge, or an edge drawn inside a facet:
  enum class New : std::uint8_t {
    blank,   // the column's default
    mean,    // the mean of the two ends of the split edge (vertices only)
    parent,  // the value in the column of the same name of the edge (for a vertex) or facet (for an edge)
  };
  // A vertex or edge into which another collapses:
  enum class Merge : std::uint8_t { keep, mean, sum };

  New on_new = New::blank;
  Merge on_merge = Merge::keep;
};
// The halves of a split edge and the parts of a split facet always copy the whole row.

using Reals = std::vector<double>;
using Integers = std::vector<std::int32_t>;
using Flags = std::vector<std::uint8_t>;

struct Column {
  std::string name;
  std::vector<int> shape;  // empty for a plain value; {3} for real[3]; {2,4} for real[2][4]
  int width = 1;           // product of the shape: values a row
  double blank = 0;        // what an element has until told otherwise
  Inheritance inheritance;
  bool user_defined = false;  // declared in a datafile, hence saved by name
  std::variant<Reals, Integers, Flags> data;

  double value(std::uint32_t row, int component = 0) const;
  void set(std::uint32_t row, int component, double value);

  void resize(std::size_t rows);
  void copy_row(std::uint32_t from, std::uint32_t to);
  void blank_row(std::uint32_t row);
  void set_mean(std::uint32_t a, std::uint32_t b, std::uint32_t to);
  // Copies a row of another column (converting between kinds of number); widths must agree.
  void copy_row_of(const Column& other, std::uint32_t from, std::uint32_t to);
  // New row i = old row old_of_new[i].
  void renumber(std::span<const std::uint32_t> old_of_new);
};

// The columns of one kind of element. Looking one up is a short linear search by name; hot loops hold the
// span.
class Columns {
 public:
  std::size_t rows() const { return rows_; }
  void resize(std::size_t rows);

  const Column* find(std::string_view name) const;
  // A number that changes whenever the column may have; 0 where there is none.
  std::uint64_t revision(std::string_view name) const;
  // Null where there is none. The column becomes this holder's own.
  Column* edit(std::string_view name);
  // Adds a column filled with its blank value; replaces one of the same name.
  Column& add(Column column);
  void remove(std::string_view name);

  // The flags of a column, or an empty span where the film has no such column (all are 0 then).
  std::span<const std::uint8_t> flags(std::string_view name) const;
  std::span<const double> reals(std::string_view name) const;

  template <class Function>
  void for_each(Function&& function) const {
    for (const Shared<Column>& column : columns_) function(*column);
  }
  template <class Function>
  void edit_each(Function&& function) {
    for (Shared<Column>& column : columns_) function(column.edit());
  }
  bool empty() const { return columns_.empty(); }
  std::size_t bytes() const;

 private:
  std::vector<Shared<Column>> columns_;
  std::size_t rows_ = 0;
};

// Ready-made columns.
Column flag_column(std::string name, Inheritance::New on_new = Inheritance::New::blank);
Column integer_column(std::string name, int blank = 0, Inheritance::New on_new = Inheritance::New::blank);
Column real_column(std::string name, double blank = 0, int width = 1,
                   Inheritance::New on_new = Inheritance::New::blank);

}  // namespace lamella::film
