#include "solve/dissection.h"

#include <algorithm>
#include <array>

namespace lamella::solve {

namespace {

using film::Vec3;

constexpr std::size_t small = 200;  // rows of a piece that is not parted further

// Who is tied to whom, both ways.
struct Graph {
  std::vector<int> start;
  std::vector<int> neighbour;
};

Graph graph_of(const LowerMatrix& pattern, std::size_t rows) {
  Graph graph;
  graph.start.assign(rows + 1, 0);
  const auto each = [&](auto&& function) {
    for (std::size_t j = 0; j < rows; ++j) {
      const auto last = static_cast<std::size_t>(pattern.column_start[j + 1]);
      for (auto at = static_cast<std::size_t>(pattern.column_start[j]); at < last; ++at) {
        const auto i = static_cast<std::size_t>(pattern.row[at]);
        if (i != j && i < rows) function(i, j);
      }
    }
  };
  each([&](std::size_t i, std::size_t j) {
    ++graph.start[i + 1];
    ++graph.start[j + 1];
  });
  for (std::size_t i = 0; i < rows; ++i) graph.start[i + 1] += graph.start[i];
  graph.neighbour.resize(static_cast<std::size_t>(graph.start[rows]));
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  each([&](std::size_t i, std::size_t j) {
    graph.neighbour[static_cast<std::size_t>(next[i]++)] = static_cast<int>(j);
    graph.neighbour[static_cast<std::size_t>(next[j]++)] = static_cast<int>(i);
  });
  return graph;
}

// A seam, or a piece that was not parted; its number is its place in the order of elimination.
struct Piece {
  int parent = -1;
};

class Dissector {
 public:
  Dissector(const LowerMatrix& pattern, std::span<const Vec3> places)
      : pattern_(pattern),
        places_(places),
        graph_(graph_of(pattern, places.size())),
        side_(places.size(), -1),
        piece_of_(static_cast<std::size_t>(pattern.size())) {}

  std::vector<int> run();

 private:
  int part(std::span<int> rows);
  int seal(std::span<const int> rows);
  bool touches(int row, int side) const;
  void place_multipliers();

  const LowerMatrix& pattern_;
  std::span<const Vec3> places_;
  Graph graph_;
  std::vector<int> side_;  // a mark of the part that a row belongs to at present
  int next_side_ = 0;
  std::vector<Piece> pieces_;
  std::vector<int> piece_of_;
};

int Dissector::seal(std::span<const int> rows) {
  for (const int row : rows) piece_of_[static_cast<std::size_t>(row)] = static_cast<int>(pieces_.size());
  pieces_.push_back({});
  return static_cast<int>(pieces_.size()) - 1;
}

bool Dissector::touches(int row, int side) const {
  const auto first = static_cast<std::size_t>(graph_.start[static_cast<std::size_t>(row)]);
  const auto last = static_cast<std::size_t>(graph_.start[static_cast<std::size_t>(row) + 1]);
  for (std::size_t i = first; i < last; ++i) {
    if (side_[static_cast<std::size_t>(graph_.neighbour[i])] == side) return true;
  }
  return false;
}

int longest_axis(std::span<const int> rows, std::span<const Vec3> places) {
  Vec3 low = places[static_cast<std::size_t>(rows[0])];
  Vec3 high = low;
  for (const int row : rows) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = places[static_cast<std::size_t>(row)][axis];
      low[axis] = std::min(low[axis], x);
      high[axis] = std::max(high[axis], x);
    }
  }
  const Vec3 size = high - low;
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

// Numbers the pieces of some rows, the seam between its parts last. Returns that number.
int Dissector::part(std::span<int> rows) {
  if (rows.size() <= small) return seal(rows);
  const int axis = longest_axis(rows, places_);
  const auto at = [&](int row) { return places_[static_cast<std::size_t>(row)][axis]; };
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
  std::nth_element(rows.begin(), middle, rows.end(), [&](int a, int b) { return at(a) < at(b); });
  const double cut = at(*middle);
  // Rows at one place stay together.
  const auto parted = std::partition(rows.begin(), rows.end(), [&](int row) { return at(row) < cut; });
  if (parted == rows.begin()) return seal(rows);
  const int low = next_side_++;
  const int high = next_side_++;
  for (auto i = rows.begin(); i != rows.end(); ++i) side_[static_cast<std::size_t>(*i)] = i < parted ? low : high;
  const auto low_seam = std::partition(rows.begin(), parted, [&](int row) { return !touches(row, high); });
  const auto high_seam = std::partition(parted, rows.end(), [&](int row) { return touches(row, low); });
  std::span<int> seam(parted, high_seam);
  std::span<int> first(rows.begin(), parted);
  std::span<int> second(high_seam, rows.end());
  if (parted - low_seam < high_seam - parted) {
    seam = {low_seam, parted};
    first = {rows.begin(), low_seam};
    second = {parted, rows.end()};
  }
  for (const int row : seam) side_[static_cast<std::size_t>(row)] = -1;
  std::array<int, 2> below{-1, -1};
  if (!first.empty()) below[0] = part(first);
  if (!second.empty()) below[1] = part(second);
  const int piece = seal(seam);
  for (const int part : below) {
    if (part >= 0) pieces_[static_cast<std::size_t>(part)].parent = piece;
  }
  return piece;
}

// To the lowest piece that is above all the pieces of the rows a multiplier is tied to.
void Dissector::place_multipliers() {
  std::vector<int> highest(piece_of_.size(), -1);
  for (std::size_t j = 0; j < places_.size(); ++j) {
    const auto last = static_cast<std::size_t>(pattern_.column_start[j + 1]);
    for (auto at = static_cast<std::size_t>(pattern_.column_start[j]); at < last; ++at) {
      const auto i = static_cast<std::size_t>(pattern_.row[at]);
      if (i < places_.size()) continue;
      int a = highest[i] < 0 ? piece_of_[j] : highest[i];
      int b = piece_of_[j];
      while (a != b) (a < b ? a : b) = pieces_[static_cast<std::size_t>(std::min(a, b))].parent;
      highest[i] = a;
    }
  }
  for (std::size_t i = places_.size(); i < piece_of_.size(); ++i)
    piece_of_[i] = highest[i] < 0 ? static_cast<int>(pieces_.size()) - 1 : highest[i];
}

std::vector<int> Dissector::run() {
  std::vector<int> rows(places_.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<int>(i);
  part(rows);
  place_multipliers();
  // Multipliers come after the rows of their piece.
  for (std::size_t i = 0; i < piece_of_.size(); ++i) piece_of_[i] = 2 * piece_of_[i] + (i < rows.size() ? 0 : 1);
  return piece_of_;
}

}  // namespace

std::vector<int> dissection(const LowerMatrix& pattern, std::span<const Vec3> places) {
  return Dissector(pattern, places).run();
}

}  // namespace lamella::solve
