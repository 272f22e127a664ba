#include "surgery/regions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "film/union_find.h"

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Region;
using film::RegionPair;
using film::Side;
using film::Triangle;
using film::Vec3;
using scene::Body;
using scene::Scene;

namespace {

// Of the cube of a shell's extent: less volume than this is none.
constexpr double flat = 1e-9;

struct Shell {
  std::vector<std::uint32_t> faces;  // 2t the front of facet t, 2t + 1 its back
  double volume = 0;                 // of the space that the faces look into, as if they closed it
  double extent = 0;
  Region region;
  bool one_label = true;

  bool is_wall() const { return one_label && volume > flat * extent * extent * extent; }
};

class Shells {
 public:
  explicit Shells(const Film& film) : film_(film), faces_(2 * std::size_t{film.triangle_rows()}) {
    for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
      if (!film.alive(Edge(i))) continue;
      film.for_each_side(Edge(i), [&](Side s) { faces_.join(after(s), before(film.next_around(s))); });
    }
  }

  std::vector<Shell> list() {
    std::vector<Shell> shells;
    std::vector<std::uint32_t> number(faces_.size(), film::no_index);
    for (std::uint32_t face = 0; face < faces_.size(); ++face) {
      if (!film_.alive(Triangle(face / 2))) continue;
      std::uint32_t& at = number[faces_.find(face)];
      if (at == film::no_index) {
        at = static_cast<std::uint32_t>(shells.size());
        shells.emplace_back().region = label(face);
      }
      shells[at].faces.push_back(face);
      shells[at].one_label = shells[at].one_label && shells[at].region == label(face);
    }
    for (Shell& shell : shells) measure(shell);
    return shells;
  }

 private:
  std::uint32_t after(Side s) const {
    return 2 * s.triangle().index + (film_.edge_of(s).reversed() ? 1U : 0U);
  }
  std::uint32_t before(Side s) const {
    return 2 * s.triangle().index + (film_.edge_of(s).reversed() ? 0U : 1U);
  }
  Region label(std::uint32_t face) const {
    const RegionPair pair = film_.regions(Triangle(face / 2));
    return face % 2 == 0 ? pair.front : pair.behind;
  }
  // What is behind a facet has its normal pointing outward.
  void measure(Shell& shell) const {
    const Vec3 origin = film_.points(Triangle(shell.faces[0] / 2))[0];
    for (const std::uint32_t face : shell.faces) {
      const auto p = film_.points(Triangle(face / 2));
      const double volume = dot(p[0] - origin, cross(p[1] - origin, p[2] - origin)) / 6;
      shell.volume += face % 2 == 0 ? -volume : volume;
      for (const Vec3& at : p) shell.extent = std::max(shell.extent, length(at - origin));
    }
  }

  const Film& film_;
  film::UnionFind faces_;
};

class Settler {
 public:
  Settler(Scene& scene, std::span<const Triangle> touched, std::span<const Region> concerned)
      : scene_(scene), touched_(touched), concerned_(concerned), shells_(Shells(scene.film).list()) {}

  std::vector<Event> run() {
    for (Shell& shell : shells_) by_region_[shell.region].push_back(&shell);
    const auto bodies = static_cast<std::uint32_t>(scene_.bodies.size());
    for (std::uint32_t r = 1; r <= bodies; ++r) divide(Region{r});
    find_births();
    find_empty();
    scene_.body_columns.resize(scene_.bodies.size());
    return std::move(events_);
  }

 private:
  void divide(Region r);
  void find_births();
  void find_empty();
  void relabel(const Shell& shell, Region to);
  Vec3 place(const Shell& shell) const { return scene_.film.points(Triangle(shell.faces[0] / 2))[0]; }

  Scene& scene_;
  std::span<const Triangle> touched_;
  std::span<const Region> concerned_;
  std::vector<Shell> shells_;
  std::map<Region, std::vector<Shell*>> by_region_;
  std::vector<Event> events_;
};

void Settler::relabel(const Shell& shell, Region to) {
  for (const std::uint32_t face : shell.faces) {
    RegionPair pair = scene_.film.regions(Triangle(face / 2));
    (face % 2 == 0 ? pair.front : pair.behind) = to;
    scene_.film.set_regions(Triangle(face / 2), pair);
  }
}

void Settler::divide(Region r) {
  std::vector<Shell*> walls;
  double cavities = 0;
  for (Shell* shell : by_region_[r]) {
    if (!shell->one_label) return;
    if (shell->is_wall()) {
      walls.push_back(shell);
    } else {
      cavities += std::min(0.0, shell->volume);
    }
  }
  if (walls.size() < 2) return;
  std::stable_sort(walls.begin(), walls.end(), [](Shell* a, Shell* b) { return a->volume > b->volume; });
  double total = cavities;
  for (const Shell* wall : walls) total += wall->volume;
  const Body whole = scene_.body(r);
  const auto share = [&](Body& body, double volume) {
    if (whole.target_volume) body.target_volume = *whole.target_volume * volume / total;
    body.ramp.reset();
  };
  share(scene_.body(r), walls[0]->volume + cavities);
  Event event{EventKind::split, place(*walls[1]), {r}};
  for (std::size_t i = 1; i < walls.size(); ++i) {
    Body piece = whole;
    if (piece.original == 0) piece.original = r.index;
    piece.volume_offset = 0;
    share(piece, walls[i]->volume);
    scene_.bodies.push_back(piece);
    const Region made{static_cast<std::uint32_t>(scene_.bodies.size())};
    relabel(*walls[i], made);
    event.regions.push_back(made);
  }
  events_.push_back(std::move(event));
}

void Settler::find_births() {
  std::vector<std::uint8_t> is_touched(scene_.film.triangle_rows());
  for (const Triangle t : touched_) is_touched[t.index] = 1;
  for (Shell* shell : by_region_[film::outside_region]) {
    const bool is_new = std::any_of(shell->faces.begin(), shell->faces.end(),
                                    [&](std::uint32_t face) { return is_touched[face / 2] != 0; });
    if (!is_new || !shell->is_wall()) continue;
    Body body;
    body.target_volume = shell->volume;
    scene_.bodies.push_back(body);
    const Region made{static_cast<std::uint32_t>(scene_.bodies.size())};
    relabel(*shell, made);
    events_.push_back({EventKind::birth, place(*shell), {made}});
  }
}

void Settler::find_empty() {
  for (const Region r : concerned_) {
    if (r.outside() || scene_.body(r).absent || !by_region_[r].empty()) continue;
    scene_.body(r).absent = true;
    events_.push_back({EventKind::vanish, {}, {r}});
  }
}

}  // namespace

std::vector<Event> settle_regions(Scene& scene, std::span<const Triangle> touched,
                                  std::span<const Region> concerned) {
  return Settler(scene, touched, concerned).run();
}

void settle_regions(Scene& scene, std::vector<Event>& events, std::span<const Triangle> touched) {
  if (events.empty()) return;
  std::vector<Region> concerned;
  for (const Event& event : events)
    concerned.insert(concerned.end(), event.regions.begin(), event.regions.end());
  std::vector<Event> more = settle_regions(scene, touched, concerned);
  // What vanished by itself has been told.
  std::erase_if(more, [&](const Event& event) {
    return event.kind == EventKind::vanish &&
           std::any_of(events.begin(), events.end(), [&](const Event& told) {
             return told.kind == EventKind::vanish && std::find(told.regions.begin(), told.regions.end(),
                                                                event.regions[0]) != told.regions.end();
           });
  });
  events.insert(events.end(), more.begin(), more.end());
}

void join_regions(Scene& scene, Region stays, Region gone) {
  if (stays == gone) return;
  for (std::uint32_t i = 0; i < scene.film.triangle_rows(); ++i) {
    if (!scene.film.alive(Triangle(i))) continue;
    RegionPair pair = scene.film.regions(Triangle(i));
    if (pair.front != gone && pair.behind != gone) continue;
    if (pair.front == gone) pair.front = stays;
    if (pair.behind == gone) pair.behind = stays;
    scene.film.set_regions(Triangle(i), pair);
  }
  Body& lost = scene.body(gone);
  lost.absent = true;
  if (stays.outside()) return;
  Body& body = scene.body(stays);
  if (body.target_volume && lost.target_volume)
    body.target_volume = *body.target_volume + *lost.target_volume;
  body.volume_offset += lost.volume_offset;
  body.ramp.reset();
}

}  // namespace lamella::surgery
