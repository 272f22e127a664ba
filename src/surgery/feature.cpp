#include "surgery/feature.h"

#include <algorithm>

#include "scene/constraint_sets.h"
#include "surgery/patch.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::Side;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

// The middle of a cubic leaves the chord by no more than this part of its length.
constexpr double most_bulge = 0.12;

bool is_held(const Scene& scene, Edge e) {
  return is_fixed(scene.film, ElementKind::edge, e.index) ||
         scene::boundary_of(scene, ElementKind::edge, e.index) != 0;
}

}  // namespace

bool is_line(const Scene& scene, Edge e) {
  const Side first = scene.film.first_side(e);
  if (!first.valid()) return true;
  const Side second = scene.film.next_around(first);
  const bool inside = second != first && scene.film.next_around(second) == first;
  return !inside || is_held(scene, e);
}

Rank rank_of(const Scene& scene, Vertex v) {
  if (is_fixed(scene.film, ElementKind::vertex, v.index)) return Rank::fixed;
  int lines = 0;
  int least = 1000;
  int most = 0;
  bool held = false;
  scene.film.for_each_end(v, [&](EdgeEnd end) {
    if (!is_line(scene, end.edge())) return;
    ++lines;
    const int valence = scene.film.valence(end.edge());
    least = std::min(least, valence);
    most = std::max(most, valence);
    held = held || is_held(scene, end.edge());
  });
  if (lines == 0) return Rank::sheet;
  if (lines != 2 || least != most) return Rank::corner;
  if (held) return Rank::wire;
  return most == 1 ? Rank::rim : Rank::border;
}

Vec3 normal_at(const Film& film, Vertex v, const Vec3& toward) {
  Vec3 sum;
  film.for_each_end(v, [&](EdgeEnd end) {
    film.for_each_side(end.edge(), [&](Side s) {
      const auto p = film.points(s.triangle());
      const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
      sum += dot(n, toward) < 0 ? -n : n;
    });
  });
  return unit(sum);
}

namespace {

Vec3 facet_normals(const Film& film, Edge e) {
  Vec3 sum;
  film.for_each_side(e, [&](Side s) {
    const auto p = film.points(s.triangle());
    const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
    sum += dot(n, sum) < 0 ? -n : n;
  });
  return sum;
}

// The direction of a line at an end of one of its edges, by the next edge on.
bool line_tangent(const Scene& scene, Edge e, Vertex v, const Vec3& chord, Vec3& tangent) {
  const Film& film = scene.film;
  Vec3 next;
  int others = 0;
  film.for_each_end(v, [&](EdgeEnd end) {
    if (end.edge() == e || !is_line(scene, end.edge())) return;
    next = film.vector(end.outward());
    ++others;
  });
  if (others != 1) return false;
  if (dot(next, chord) < 0) next = -next;
  // The circle through three points: each chord weighs by the inverse of its length squared.
  tangent = unit(chord / squared_length(chord) + next / squared_length(next));
  return true;
}

}  // namespace

Vec3 smooth_middle(const Scene& scene, Edge e) {
  const Film& film = scene.film;
  const auto [tail, head] = film.ends(e);
  const Vec3 chord = film.vector(film::SignedEdge(e, false));
  const Vec3 middle = film.position(tail) + 0.5 * chord;
  Vec3 at_tail;
  Vec3 at_head;
  if (is_line(scene, e)) {
    if (!line_tangent(scene, e, tail, chord, at_tail) || !line_tangent(scene, e, head, chord, at_head))
      return middle;
  } else {
    const Vec3 toward = facet_normals(film, e);
    const auto tangent = [&](Vertex v) {
      if (rank_of(scene, v) != Rank::sheet) return unit(chord);
      const Vec3 n = normal_at(film, v, toward);
      return unit(chord - dot(chord, n) * n);
    };
    at_tail = tangent(tail);
    at_head = tangent(head);
    // With one end on a line, the curvature at the other stands for both.
    const bool tail_inside = rank_of(scene, tail) == Rank::sheet;
    const bool head_inside = rank_of(scene, head) == Rank::sheet;
    if (!tail_inside && !head_inside) return middle;
    if (!tail_inside) at_head = 2 * at_head - unit(chord);
    if (!head_inside) at_tail = 2 * at_tail - unit(chord);
  }
  Vec3 bulge = (length(chord) / 8) * (at_tail - at_head);
  const double far = length(bulge);
  const double most = most_bulge * length(chord);
  if (far > most) bulge = (most / far) * bulge;
  return middle + bulge;
}

}  // namespace lamella::surgery
