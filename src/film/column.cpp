#include "film/column.h"

#include <algorithm>
#include <cmath>

namespace lamella::film {

namespace {

template <class Value>
Value converted(double value) {
  if constexpr (std::is_same_v<Value, double>) {
    return value;
  } else if constexpr (std::is_same_v<Value, std::uint8_t>) {
    return value != 0 ? 1 : 0;
  } else {
    return static_cast<Value>(std::llround(value));
  }
}

}  // namespace

std::string_view name_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::vertex:
      return "vertex";
    case ElementKind::edge:
      return "edge";
    case ElementKind::facet:
      return "facet";
    case ElementKind::body:
      return "body";
  }
  return "";
}

double Column::value(std::uint32_t row, int component) const {
  const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(component);
  return std::visit([&](const auto& values) { return static_cast<double>(values[at]); }, data);
}

void Column::set(std::uint32_t row, int component, double value) {
  const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(component);
  std::visit(
      [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        values[at] = converted<Value>(value);
      },
      data);
}

void Column::resize(std::size_t rows) {
  std::visit(
      [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        values.resize(rows * static_cast<std::size_t>(width), converted<Value>(blank));
      },
      data);
}

void Column::copy_row(std::uint32_t from, std::uint32_t to) {
  std::visit(
      [&](auto& values) {
        const auto w = static_cast<std::ptrdiff_t>(width);
        std::copy_n(values.begin() + w * from, w, values.begin() + w * to);
      },
      data);
}

void Column::blank_row(std::uint32_t row) {
  for (int k = 0; k < width; ++k) set(row, k, blank);
}

void Column::set_mean(std::uint32_t a, std::uint32_t b, std::uint32_t to) {
  for (int k = 0; k < width; ++k) set(to, k, 0.5 * (value(a, k) + value(b, k)));
}

void Column::copy_row_of(const Column& other, std::uint32_t from, std::uint32_t to) {
  for (int k = 0; k < std::min(width, other.width); ++k) set(to, k, other.value(from, k));
}

void Column::renumber(std::span<const std::uint32_t> old_of_new) {
  std::visit(
      [&](auto& values) {
        const auto w = static_cast<std::size_t>(width);
        std::decay_t<decltype(values)> moved(old_of_new.size() * w);
        for (std::size_t i = 0; i < old_of_new.size(); ++i) {
          for (std::size_t k = 0; k < w; ++k) moved[i * w + k] = values[old_of_new[i] * w + k];
        }
        values = std::move(moved);
      },
      data);
}

void Columns::resize(std::size_t rows) {
  if (rows == rows_) return;
  rows_ = rows;
  for (Shared<Column>& column : columns_) column.edit().resize(rows);
}

const Column* Columns::find(std::string_view name) const {
  for (const Shared<Column>& column : columns_) {
    if (column->name == name) return &*column;
  }
  return nullptr;
}

std::uint64_t Columns::revision(std::string_view name) const {
  for (const Shared<Column>& column : columns_) {
    if (column->name == name) return column.revision();
  }
  return 0;
}

Column* Columns::edit(std::string_view name) {
  for (Shared<Column>& column : columns_) {
    if (column->name == name) return &column.edit();
  }
  return nullptr;
}

Column& Columns::add(Column column) {
  remove(column.name);
  column.resize(rows_);
  columns_.emplace_back(std::move(column));
  return columns_.back().edit();
}

void Columns::remove(std::string_view name) {
  std::erase_if(columns_, [&](const Shared<Column>& column) { return column->name == name; });
}

std::span<const std::uint8_t> Columns::flags(std::string_view name) const {
  const Column* column = find(name);
  const Flags* values = column != nullptr ? std::get_if<Flags>(&column->data) : nullptr;
  return values != nullptr ? std::span<const std::uint8_t>(*values) : std::span<const std::uint8_t>{};
}

std::span<const double> Columns::reals(std::string_view name) const {
  const Column* column = find(name);
  const Reals* values = column != nullptr ? std::get_if<Reals>(&column->data) : nullptr;
  return values != nullptr ? std::span<const double>(*values) : std::span<const double>{};
}

std::size_t Columns::bytes() const {
  std::size_t total = 0;
  for_each([&](const Column& column) {
    std::visit([&](const auto& values) { total += values.capacity() * sizeof(values[0]); }, column.data);
  });
  return total;
}

Column flag_column(std::string name, Inheritance::New on_new) {
  Column column;
  column.name = std::move(name);
  column.inheritance.on_new = on_new;
  column.data = Flags{};
  return column;
}

Column integer_column(std::string name, int blank, Inheritance::New on_new) {
  Column column;
  column.name = std::move(name);
  column.blank = blank;
  column.inheritance.on_new = on_new;
  column.data = Integers{};
  return column;
}

Column real_column(std::string name, double blank, int width, Inheritance::New on_new) {
  Column column;
  column.name = std::move(name);
  column.blank = blank;
  column.width = width;
  if (width > 1) column.shape = {width};
  column.inheritance.on_new = on_new;
  column.data = Reals{};
  return column;
}

}  // namespace lamella::film
