#include "exchange/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "film/union_find.h"

namespace lamella::exchange {

using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;

namespace {

// What faces of facets bound together: 2t is the front of facet t, 2t + 1 its back.
struct Shell {
  std::uint32_t piece = 0;
  double volume = 0;
  std::uint32_t region = 0;
};

// A connected piece of film.
struct Piece {
  std::vector<std::uint32_t> triangles;
  Vec3 low;
  Vec3 high;
  std::uint32_t around = 0;  // the shell that the space around it has
  Vec3 sample;               // a point inside one of its facets
};

class CellFinder {
 public:
  explicit CellFinder(const Film& film)
      : film_(film), faces_(2 * std::size_t{film.triangle_rows()}), pieces_of_(film.triangle_rows()) {}

  Cells find() {
    join();
    collect();
    choose_surroundings();
    number();
    nest();
    Cells cells;
    for (const auto& [face, shell] : shells_) cells.count = std::max(cells.count, shell.region);
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t)
      cells.regions.push_back({film::Region{shell(2 * t).region}, film::Region{shell(2 * t + 1).region}});
    return cells;
  }

 private:
  Shell& shell(std::uint32_t face) { return shells_[faces_.find(face)]; }

  // Counterclockwise about an edge comes the front of a side that runs along it.
  void join() {
    for (std::uint32_t i = 0; i < film_.edge_rows(); ++i) {
      film_.for_each_side(film::Edge(i), [&](Side s) {
        const Side next = film_.next_around(s);
        const std::uint32_t t = s.triangle().index;
        const std::uint32_t u = next.triangle().index;
        faces_.join(2 * t + (film_.edge_of(s).reversed() ? 1U : 0U),
                    2 * u + (film_.edge_of(next).reversed() ? 0U : 1U));
        pieces_of_.join(t, u);
      });
    }
  }

  void collect() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) {
      const std::uint32_t own = pieces_of_.find(t);
      const auto [at, made] = pieces_.try_emplace(own);
      Piece& piece = at->second;
      const std::array<Vec3, 3> p = film_.points(Triangle(t));
      if (made) {
        piece.low = {infinity, infinity, infinity};
        piece.high = -piece.low;
        piece.sample = (p[0] + p[1] + p[2]) / 3;
      }
      piece.triangles.push_back(t);
      for (const Vec3& corner : p) {
        for (int k = 0; k < 3; ++k) {
          piece.low[k] = std::min(piece.low[k], corner[k]);
          piece.high[k] = std::max(piece.high[k], corner[k]);
        }
      }
      const Vec3 o = piece.sample;
      const double volume = dot(p[0] - o, cross(p[1] - o, p[2] - o)) / 6;
      for (const std::uint32_t side : {0U, 1U}) {
        Shell& own_shell = shell(2 * t + side);
        own_shell.piece = own;
        own_shell.volume += side == 0 ? -volume : volume;
      }
    }
  }

  void choose_surroundings() {
    std::map<std::uint32_t, double> least;
    for (const auto& [face, shell] : shells_) {
      const auto [at, made] = least.try_emplace(shell.piece, shell.volume);
      if (!made && shell.volume >= at->second) continue;
      at->second = shell.volume;
      pieces_[shell.piece].around = face;
    }
  }

  void number() {
    std::uint32_t regions = 0;
    for (auto& [face, shell] : shells_) {
      if (pieces_[shell.piece].around != face) shell.region = ++regions;
    }
  }

  // What is around a piece is the innermost region of another one that holds it.
  void nest() {
    if (pieces_.size() < 2) return;
    for (const auto& [own, piece] : pieces_) {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [other, candidate] : pieces_) {
        if (other == own || !holds(candidate, piece.sample)) continue;
        const Shell* const inside = region_at(candidate, piece.sample);
        if (inside == nullptr || inside->volume >= least) continue;
        least = inside->volume;
        shells_[piece.around].region = inside->region;
      }
    }
  }

  static bool holds(const Piece& piece, const Vec3& p) {
    return p.x > piece.low.x && p.y > piece.low.y && p.z > piece.low.z && p.x < piece.high.x &&
           p.y < piece.high.y && p.z < piece.high.z;
  }

  // The shell of a piece that winds around a point, by the solid angles of its faces; null where that is the
  // one around the piece.
  const Shell* region_at(const Piece& piece, const Vec3& p) {
    std::map<std::uint32_t, double> angles;
    for (const std::uint32_t t : piece.triangles) {
      const double angle = solid_angle(film_.points(Triangle(t)), p);
      angles[faces_.find(2 * t)] -= angle;
      angles[faces_.find(2 * t + 1)] += angle;
    }
    for (const auto& [face, angle] : angles) {
      if (face != piece.around && angle > 2 * std::numbers::pi) return &shells_[face];
    }
    return nullptr;
  }

  // Of a triangle seen from a point, positive from behind it (A. van Oosterom and J. Strackee, "The solid
  // angle of a plane triangle", 1983).
  static double solid_angle(const std::array<Vec3, 3>& corners, const Vec3& from) {
    const Vec3 a = corners[0] - from;
    const Vec3 b = corners[1] - from;
    const Vec3 c = corners[2] - from;
    const double la = length(a);
    const double lb = length(b);
    const double lc = length(c);
    return 2 *
           std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }

  const Film& film_;
  film::UnionFind faces_;
  film::UnionFind pieces_of_;
  std::map<std::uint32_t, Shell> shells_;  // by the lowest of their faces
  std::map<std::uint32_t, Piece> pieces_;  // by the lowest of their triangles
};

}  // namespace

Cells find_cells(const Film& film) {
  return CellFinder(film).find();
}

}  // namespace lamella::exchange
