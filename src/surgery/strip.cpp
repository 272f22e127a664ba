#include "surgery/strip.h"

#include <algorithm>
#include <cmath>

namespace lamella::surgery {

using film::Film;
using film::Vec3;
using film::Vertex;

namespace {

// Of an edge across the band, in units of its length squared: among bands of like area the even one is taken.
constexpr double edge_cost = 0.05;

// Dynamic programming over how far each line has been followed.
class StripMaker {
 public:
  StripMaker(const Film& film, const std::vector<Vertex>& inner, const std::vector<Vertex>& outer)
      : film_(film), inner_(inner), outer_(outer), width_(outer.size()) {}

  Strip make() {
    fill();
    Strip strip;
    std::size_t i = inner_.size() - 1;
    std::size_t j = outer_.size() - 1;
    while (i > 0 || j > 0) {
      const bool by_inner = by_inner_[at(i, j)];
      const std::array<Vertex, 3> facet = by_inner
                                              ? std::array<Vertex, 3>{inner_[i], inner_[i - 1], outer_[j]}
                                              : std::array<Vertex, 3>{outer_[j - 1], outer_[j], inner_[i]};
      (by_inner ? i : j) -= 1;
      if (is_degenerate(facet)) continue;
      strip.facets.push_back(facet);
      strip.area += area(facet);
    }
    return strip;
  }

 private:
  std::size_t at(std::size_t i, std::size_t j) const { return i * width_ + j; }
  void fill() {
    cost_.assign(inner_.size() * width_, HUGE_VAL);
    by_inner_.assign(cost_.size(), false);
    cost_[0] = 0;
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      for (std::size_t j = 0; j < width_; ++j) {
        if (i > 0) consider(i, j, cost_[at(i - 1, j)] + price({inner_[i], inner_[i - 1], outer_[j]}), true);
        if (j > 0) consider(i, j, cost_[at(i, j - 1)] + price({outer_[j - 1], outer_[j], inner_[i]}), false);
      }
    }
  }
  void consider(std::size_t i, std::size_t j, double cost, bool by_inner) {
    if (cost >= cost_[at(i, j)]) return;
    cost_[at(i, j)] = cost;
    by_inner_[at(i, j)] = by_inner;
  }
  // At a common end the lines' corners are one.
  static bool is_degenerate(const std::array<Vertex, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }
  double area(const std::array<Vertex, 3>& t) const {
    const Vec3& a = film_.position(t[0]);
    return 0.5 * length(cross(film_.position(t[1]) - a, film_.position(t[2]) - a));
  }
  double price(const std::array<Vertex, 3>& t) const {
    return area(t) + edge_cost * squared_length(film_.position(t[0]) - film_.position(t[2]));
  }

  const Film& film_;
  const std::vector<Vertex>& inner_;
  const std::vector<Vertex>& outer_;
  std::size_t width_;
  std::vector<double> cost_;
  std::vector<bool> by_inner_;
};

}  // namespace

Strip strip_between_loops(const Film& film, std::vector<Vertex> inner, std::vector<Vertex> outer) {
  double least = HUGE_VAL;
  std::ptrdiff_t first_inner = 0;
  std::ptrdiff_t first_outer = 0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    for (std::size_t j = 0; j < outer.size(); ++j) {
      const double distance = squared_length(film.position(inner[i]) - film.position(outer[j]));
      if (distance >= least) continue;
      least = distance;
      first_inner = static_cast<std::ptrdiff_t>(i);
      first_outer = static_cast<std::ptrdiff_t>(j);
    }
  }
  std::rotate(inner.begin(), inner.begin() + first_inner, inner.end());
  std::rotate(outer.begin(), outer.begin() + first_outer, outer.end());
  inner.push_back(inner[0]);
  outer.push_back(outer[0]);
  return StripMaker(film, inner, outer).make();
}

Strip strip_between_lines(const Film& film, const std::vector<Vertex>& inner,
                          const std::vector<Vertex>& outer) {
  return StripMaker(film, inner, outer).make();
}

}  // namespace lamella::surgery
