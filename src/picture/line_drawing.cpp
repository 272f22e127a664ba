#include "picture/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lamella::picture {

namespace {

using film::Vec3;

// Lines are sampled at this distance, in heights of the picture, and the place where one disappears is then
// found more exactly.
constexpr double sampling = 0.004;
constexpr int bisections = 6;

// How much nearer a film must be to hide a line, in radii of the scene. Edges lie in their facets exactly; an
// outline runs through the flat facets of a curved film, which rise above it a little.
constexpr double edge_clearance = 2e-3;
constexpr double outline_clearance = 3e-2;

// A point of the picture and its depth. Between two such points the inverse of the depth (parallel: the depth
// itself) changes evenly.
struct Seen {
  double x = 0;
  double y = 0;
  double depth = 0;
};

Seen between(const Seen& a, const Seen& b, double part, bool parallel) {
  const double depth =
      parallel ? a.depth + part * (b.depth - a.depth) : 1 / ((1 - part) / a.depth + part / b.depth);
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), depth};
}

// Triangles by the cell of a grid over the picture.
class FilmGrid {
 public:
  FilmGrid(const Drawing& drawing, std::vector<Seen> seen, bool parallel, double aspect)
      : drawing_(drawing), seen_(std::move(seen)), parallel_(parallel) {
    const double cells = std::clamp(static_cast<double>(drawing.triangles.size()) / 2, 16.0, 250000.0);
    rows_ = static_cast<int>(std::ceil(std::sqrt(cells / aspect)));
    columns_ = static_cast<int>(std::ceil(rows_ * aspect));
    cell_ = 1.0 / rows_;
    fill();
  }

  // Whether a film lies before a point, by more than the clearance.
  bool hides(const Seen& p, double clearance) const {
    const int column = cell_of(p.x, columns_);
    const int row = cell_of(p.y, rows_);
    const auto cell = static_cast<std::size_t>(row * columns_ + column);
    for (std::size_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
      if (lies_before(drawing_.triangles[list_[i]], p, clearance)) return true;
    }
    return false;
  }

 private:
  int cell_of(double at, int count) const { return std::clamp(static_cast<int>(at / cell_), 0, count - 1); }

  template <class Function>
  void for_each_cell(const std::array<std::uint32_t, 3>& t, Function&& function) const {
    const auto [left, right] = std::minmax({seen_[t[0]].x, seen_[t[1]].x, seen_[t[2]].x});
    const auto [top, bottom] = std::minmax({seen_[t[0]].y, seen_[t[1]].y, seen_[t[2]].y});
    for (int row = cell_of(top, rows_); row <= cell_of(bottom, rows_); ++row) {
      for (int column = cell_of(left, columns_); column <= cell_of(right, columns_); ++column)
        function(static_cast<std::size_t>(row * columns_ + column));
    }
  }

  void fill() {
    begin_.assign(static_cast<std::size_t>(rows_ * columns_) + 1, 0);
    for (const auto& t : drawing_.triangles) for_each_cell(t, [&](std::size_t cell) { ++begin_[cell + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    list_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t t = 0; t < drawing_.triangles.size(); ++t)
      for_each_cell(drawing_.triangles[t], [&](std::size_t cell) { list_[next[cell]++] = t; });
  }

  bool lies_before(const std::array<std::uint32_t, 3>& t, const Seen& p, double clearance) const {
    const Seen& a = seen_[t[0]];
    const Seen& b = seen_[t[1]];
    const Seen& c = seen_[t[2]];
    const double whole = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (whole == 0) return false;
    const double u = ((b.x - p.x) * (c.y - p.y) - (b.y - p.y) * (c.x - p.x)) / whole;
    const double v = ((c.x - p.x) * (a.y - p.y) - (c.y - p.y) * (a.x - p.x)) / whole;
    const double w = 1 - u - v;
    if (u < 0 || v < 0 || w < 0) return false;
    const double depth =
        parallel_ ? u * a.depth + v * b.depth + w * c.depth : 1 / (u / a.depth + v / b.depth + w / c.depth);
    return depth < p.depth - clearance;
  }

  const Drawing& drawing_;
  std::vector<Seen> seen_;
  bool parallel_;
  int rows_ = 1;
  int columns_ = 1;
  double cell_ = 1;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> list_;
};

struct Piece {
  Spot from;
  Spot to;
  LineKind kind = LineKind::none;
  bool hidden = false;
};

class StrokeFinder {
 public:
  StrokeFinder(const Drawing& drawing, const Camera& camera, double aspect)
      : drawing_(drawing),
        camera_(camera),
        aspect_(aspect),
        films_(drawing, all_seen(), camera.parallel, aspect) {}

  std::vector<Piece> find() {
    for (const Tube& tube : drawing_.tubes) {
      if (tube.kind == LineKind::mesh || tube.from == tube.to) continue;
      split(seen(tube.from), seen(tube.to), tube.kind, edge_clearance);
    }
    for (const auto& t : drawing_.triangles) outline(t);
    return std::move(pieces_);
  }

 private:
  Seen seen(const Point& p) const {
    const Vec3 at = camera_.project({p[0], p[1], p[2]});
    return {(at.x + 1) / 2 * aspect_, (1 - at.y) / 2, at.z};
  }

  std::vector<Seen> all_seen() const {
    std::vector<Seen> result;
    result.reserve(drawing_.positions.size());
    for (const Point& p : drawing_.positions) result.push_back(seen(p));
    return result;
  }

  // Positive where a film's front is seen.
  double facing(std::uint32_t v) const {
    const Point& p = drawing_.positions[v];
    const Point& n = drawing_.normals[v];
    const Vec3 normal{n[0], n[1], n[2]};
    if (camera_.parallel) return dot(normal, camera_.axes[2]);
    const Axes& a = camera_.axes;
    const Vec3 eye = camera_.eye.x * a[0] + camera_.eye.y * a[1] + camera_.eye.z * a[2];
    return dot(normal, eye - Vec3{p[0], p[1], p[2]});
  }

  // The line across a facet at which the film turns away from the viewer.
  void outline(const std::array<std::uint32_t, 3>& t) {
    std::array<Seen, 2> ends;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3 && count < 2; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      const double fa = facing(a);
      const double fb = facing(b);
      if ((fa < 0) == (fb < 0)) continue;
      const auto part = static_cast<float>(fa / (fa - fb));
      const Point& p = drawing_.positions[a];
      const Point& q = drawing_.positions[b];
      ends[count++] =
          seen({p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]), p[2] + part * (q[2] - p[2])});
    }
    if (count == 2) split(ends[0], ends[1], LineKind::none, outline_clearance);
  }

  void split(const Seen& a, const Seen& b, LineKind kind, double clearance) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / sampling)));
    const auto hidden_at = [&](double part) {
      return films_.hides(between(a, b, part, camera_.parallel), clearance);
    };
    const auto spot = [&](double part) { return Spot{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)}; };
    // Samples lie inside the line: its ends touch other films.
    bool hidden = hidden_at(0.5 / steps);
    double begin = 0;
    double before = 0.5 / steps;
    for (int i = 1; i < steps; ++i) {
      const double here = (i + 0.5) / steps;
      const bool now = hidden_at(here);
      if (now != hidden) {
        const double change = where_it_changes(hidden_at, before, here, hidden);
        pieces_.push_back({spot(begin), spot(change), kind, hidden});
        begin = change;
        hidden = now;
      }
      before = here;
    }
    pieces_.push_back({spot(begin), spot(1), kind, hidden});
  }

  template <class Function>
  static double where_it_changes(const Function& hidden_at, double low, double high, bool hidden) {
    for (int i = 0; i < bisections; ++i) {
      const double middle = (low + high) / 2;
      (hidden_at(middle) == hidden ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  const Drawing& drawing_;
  const Camera& camera_;
  double aspect_;
  FilmGrid films_;
  std::vector<Piece> pieces_;
};

// Pieces joined end to end to long strokes.
class Joiner {
 public:
  explicit Joiner(std::vector<Piece> pieces) : pieces_(std::move(pieces)), used_(pieces_.size(), 0) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const Spot& end : {pieces_[i].from, pieces_[i].to}) at_[key(end, pieces_[i])].push_back(i);
    }
  }

  std::vector<Stroke> join() {
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i] != 0) continue;
      used_[i] = 1;
      std::vector<Spot> forward = {pieces_[i].from, pieces_[i].to};
      extend(forward, pieces_[i]);
      std::reverse(forward.begin(), forward.end());
      extend(forward, pieces_[i]);
      strokes.push_back({std::move(forward), pieces_[i].kind, pieces_[i].hidden});
    }
    return strokes;
  }

 private:
  using Key = std::array<long, 4>;
  static Key key(const Spot& spot, const Piece& piece) {
    constexpr double grain = 1e5;
    return {std::lround(spot.x * grain), std::lround(spot.y * grain), static_cast<long>(piece.kind),
            piece.hidden ? 1L : 0L};
  }

  // Goes on from the last spot for as long as there is just one way.
  void extend(std::vector<Spot>& spots, const Piece& piece) {
    while (true) {
      const Key here = key(spots.back(), piece);
      const std::vector<std::size_t>& ends = at_[here];
      if (ends.size() != 2) return;
      const std::size_t next = used_[ends[0]] == 0 ? ends[0] : ends[1];
      if (used_[next] != 0) return;
      used_[next] = 1;
      const Piece& p = pieces_[next];
      spots.push_back(key(p.from, piece) == here ? p.to : p.from);
    }
  }

  std::vector<Piece> pieces_;
  std::vector<std::uint8_t> used_;
  std::map<Key, std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<Stroke> find_strokes(const Drawing& drawing, const Camera& camera, double aspect) {
  return Joiner(StrokeFinder(drawing, camera, aspect).find()).join();
}

}  // namespace lamella::picture
