#include "evolution/stiff_spots.h"

#include <algorithm>
#include <cmath>

namespace lamella::evolution {

namespace {

// What is gained after so many vertices is little, and each costs as much as some fifteen facets of a sweep.
constexpr int most_relieved = 16;
// A vertex's d is made smaller by the ratio to the stiffest neighbour, within these; half of that (of its
// logarithm) is tried next.
constexpr double strongest = 0.4;
constexpr double weakest = 0.9;
constexpr int most_tries = 3;
constexpr double gain = 0.999;  // is worth it

// The diagonal of a triangle's K: squared sides over four times the area.
std::array<double, 3> diagonal_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double factor = 0.5 / length(cross(b - a, c - a));
  return {factor * squared_length(c - b), factor * squared_length(a - c), factor * squared_length(b - a)};
}

// k, where `lightness` is 1/d: with T the sum of K_ii/d_i, and as all 2x2 minors of K are 1/4, k = (T +
// sqrt(T^2
// - sum of 1/(d_i d_j)))/2.
double relative_stiffness(const std::array<double, 3>& diagonal, const std::array<double, 3>& lightness) {
  const auto& [a, b, c] = lightness;
  const double trace = diagonal[0] * a + diagonal[1] * b + diagonal[2] * c;
  return 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - (a * b + b * c + c * a))));
}

}  // namespace

void StiffSpots::touch(const Mesh& mesh, film::Vertex v) {
  State& state = states_[v.index];
  if (state.d > 0) return;
  state = {mesh.lines[v.index].stiffness * mesh.weights[v.index], 1};
  touched_.push_back(v);
}

film::Vertex StiffSpots::stiffest() const {
  film::Vertex first = touched_.front();
  for (const film::Vertex v : touched_) {
    const double rate = states_[v.index].rate;
    const double most_yet = states_[first.index].rate;
    if (rate > most_yet || (rate == most_yet && v < first)) first = v;
  }
  return first;
}

// In ascending order: that in which edges stand around a vertex is not the film's own.
void StiffSpots::find_star(const Mesh& mesh, film::Vertex v) {
  star_.clear();
  mesh.film.for_each_end(v, [&](film::EdgeEnd end) {
    mesh.film.for_each_side(end.edge(), [&](film::Side side) {
      if (mesh.film.corners(side.triangle())[static_cast<std::size_t>(side.corner())] == v)
        star_.push_back({side.triangle().index, {}});
    });
  });
  std::sort(star_.begin(), star_.end(),
            [](const Piece& a, const Piece& b) { return a.triangle < b.triangle; });
  for (Piece& piece : star_) {
    const auto& [a, b, c] = mesh.triangles[piece.triangle];
    piece.corners = mesh.film.corners(film::Triangle(piece.triangle));
    piece.diagonal = diagonal_of(mesh.positions[a.index], mesh.positions[b.index], mesh.positions[c.index]);
    if (!mesh.tension.empty()) piece.tension = mesh.tension[piece.triangle];
  }
}

// Adds the shares of the star's triangles, by the present d, to the rates of its vertices.
void StiffSpots::add_star(const Mesh& mesh, double sign) {
  for (const Piece& piece : star_) {
    std::array<double, 3> lightness{};
    for (std::size_t i = 0; i < 3; ++i) lightness[i] = 1 / states_[piece.corners[i].index].d;
    const double k = sign * piece.tension * relative_stiffness(piece.diagonal, lightness);
    for (const film::Vertex v : piece.corners)
      states_[v.index].rate += k * states_[v.index].d * mesh.weights[v.index];
  }
}

// Makes the d of a vertex smaller so that no vertex around is as stiff as it was; false where that fails.
bool StiffSpots::relieve_one(const Mesh& mesh, film::Vertex v) {
  find_star(mesh, v);
  const double most_before = states_[v.index].rate;
  const double d = states_[v.index].d;
  double next = 0;
  rates_before_.clear();
  for (const Piece& piece : star_) {
    for (const film::Vertex corner : piece.corners) {
      touch(mesh, corner);
      rates_before_.push_back(states_[corner.index].rate);
      if (corner != v) next = std::max(next, rates_before_.back());
    }
  }
  double factor = std::clamp(next / most_before, strongest, weakest);
  for (int attempt = 0; attempt < most_tries; ++attempt, factor = std::sqrt(factor)) {
    add_star(mesh, -1);
    states_[v.index].d = factor * d;
    add_star(mesh, 1);
    const bool helps = std::all_of(star_.begin(), star_.end(), [&](const Piece& piece) {
      return std::all_of(piece.corners.begin(), piece.corners.end(), [&](film::Vertex corner) {
        return states_[corner.index].rate < gain * most_before;  // not where it is no number
      });
    });
    if (helps) return true;
    states_[v.index].d = d;
    for (std::size_t i = 0; i < rates_before_.size(); ++i)
      states_[star_[i / 3].corners[i % 3].index].rate = rates_before_[i];
  }
  return false;
}

double StiffSpots::relieve(const Mesh& mesh, std::span<const film::Vertex> spots, double largest) {
  if (spots.empty() || spots.size() > most || !std::isfinite(largest)) return largest;
  states_.resize(mesh.weights.size());
  for (const film::Vertex v : spots) touch(mesh, v);
  for (int relieved = 0; relieved < most_relieved; ++relieved) {
    const film::Vertex v = stiffest();
    if (states_[v.index].rate <= watched * largest || !relieve_one(mesh, v)) break;
  }
  const double bound = std::max(states_[stiffest().index].rate, watched * largest);
  for (const film::Vertex v : touched_) states_[v.index] = {};
  touched_.clear();
  return bound;
}

}  // namespace lamella::evolution
