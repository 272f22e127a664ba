#include "evolution/topology.h"

#include <algorithm>
#include <cmath>

#include "energy/film_energy.h"
#include "evolution/changed_mesh.h"
#include "evolution/masses.h"
#include "evolution/mesh_noise.h"
#include "evolution/rigid_velocity.h"
#include "film/check.h"
#include "scene/constraint_sets.h"
#include "surgery/sizing.h"

namespace lamella::evolution {

using film::ElementKind;
using film::Film;
using film::Vertex;
using scene::Scene;

namespace {

// In units of the mesh's size.
constexpr double look_after = 0.05;  // the way of a vertex from look to look
constexpr double look_after_tight = 0.01;
constexpr double mend_after = 0.3;  // and until what can wait is mended
constexpr double look_at_end = 1e-3;
constexpr double evened_from = 0.1;   // the way of a vertex to the middle of those around it
constexpr double contact = 0.15;      // sheets nearer than this touch
constexpr double near_margin = 0.15;  // beyond that, sheets are near one another
constexpr double step_near = 0.05;    // the way in a step of sheets that are near one another
constexpr double step_any = 0.25;     // and of any vertex
constexpr double hard_gap = 0.08;     // sheets that touch and cannot merge come no nearer

constexpr double noise_taken = 0.65;  // of the speed at which neighbours part within their film, a pass

constexpr int most_rings_held = 5;  // around films that would meet where volumes are restored
// The velocities around a change of the mesh are scaled by no more than this, to keep the energy.
constexpr double least_factor = 0.9;
constexpr double most_factor = 1.1;

film::Reals& reals(Film& film, const char* name) {
  return std::get<film::Reals>(film.columns(ElementKind::vertex).edit(name)->data);
}

// What the corners of a triangle have in a point of it.
std::array<double, 3> parts_at(const std::array<Vec3, 3>& triangle, const Vec3& p) {
  const Vec3 n = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double square = squared_length(n);
  if (!(square > 0)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  const double second = dot(n, cross(p - triangle[0], triangle[2] - triangle[0])) / square;
  const double third = dot(n, cross(triangle[1] - triangle[0], p - triangle[0])) / square;
  return {1 - second - third, second, third};
}

// Volumes restored while some vertices stay where they are.
std::unique_ptr<solve::Problem> restored_elsewhere(Scene& scene, std::span<const surgery::Tangle> held) {
  film::Columns& columns = scene.film.columns(ElementKind::vertex);
  const film::Column* const known = columns.find("fixed");
  const std::optional<film::Column> before = known != nullptr ? std::optional(*known) : std::nullopt;
  film::Column& fixed =
      columns.add(before.value_or(film::flag_column("fixed", film::Inheritance::New::parent)));
  for (const surgery::Tangle& tangle : held) {
    for (const Vertex v : tangle) fixed.set(v.index, 0, 1);
  }
  std::unique_ptr<solve::Problem> problem = restored(scene);
  if (before)
    columns.add(*before);
  else
    columns.remove("fixed");
  return problem;
}

// Flags, by the rows of the film after compaction, for vertices named by rows before.
std::vector<std::uint8_t> compact_with_flags(Film& film, std::span<const Vertex> touched) {
  std::vector<std::uint8_t> before(film.vertex_rows());
  for (const Vertex v : touched) before[v.index] = 1;
  std::vector<std::uint8_t> after;
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    if (film.alive(Vertex(v))) after.push_back(before[v]);
  }
  film.compact();
  return after;
}

// Masses and velocities of the vertices that surgery has touched.
class Touched {
 public:
  Touched(Scene& scene, std::vector<std::uint8_t> flags) : scene_(scene), flags_(std::move(flags)) {
    const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
    free_.assign(flags_.size(), 1);
    for (std::size_t v = 0; v < fixed.size(); ++v) free_[v] = fixed[v] == 0 ? 1 : 0;
    masses_ = reals(scene.film, "mass");
    velocities_ = velocities(scene.film);
  }

  // What mass the touched vertices have, and what was lost with others, spread by area.
  void spread_mass(double total, energy::FilmEnergy& terms) {
    energy_ = terms.gradient(scene_.film.positions());
    double elsewhere = 0;
    double area = 0;
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      if (flags_[v] != 0)
        area += terms.lines()[v].area;
      else
        elsewhere += masses_[v];
    }
    if (area <= 0) return;
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      if (flags_[v] != 0) masses_[v] = terms.lines()[v].area * std::max(0.0, total - elsewhere) / area;
    }
  }

  // By a turn of the whole film, where nothing holds it: it is little, and few vertices would have to turn
  // fast for it.
  void restore_angular_momentum(const Vec3& wanted) {
    const Balance now = balance();
    if (kept_by(scene_) != Kept::both_momenta || !(now.mass > 0)) return;
    Balance missing;
    missing.mass = now.mass;
    missing.angular_momentum = wanted - now.angular_momentum;
    const std::span<const Vec3> x = scene_.film.positions();
    const RigidVelocity turn = rigid_velocity(missing, x, masses_, Kept::both_momenta);
    for (std::size_t v = 0; v < velocities_.size(); ++v) velocities_[v] += turn.at(x[v]);
  }

  void restore_momentum(const Vec3& wanted) {
    const Balance now = balance();
    double mass = 0;
    for (std::size_t v = 0; v < flags_.size(); ++v) mass += counts(v) ? masses_[v] : 0;
    if (mass <= 0) return;
    const Vec3 shift = (wanted - now.momentum) / mass;
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      if (counts(v)) velocities_[v] += shift;
    }
  }

  // Scales what the velocities differ by from their mean, so that this kinetic energy is added.
  void add_kinetic(double energy) {
    Vec3 mean;
    double mass = 0;
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      if (!counts(v)) continue;
      mean += masses_[v] * velocities_[v];
      mass += masses_[v];
    }
    if (mass <= 0) return;
    mean = mean / mass;
    double moving = 0;
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      if (counts(v)) moving += 0.5 * masses_[v] * squared_length(velocities_[v] - mean);
    }
    if (moving <= 0) return;
    const double factor =
        std::clamp(std::sqrt(std::max(0.0, 1 + energy / moving)), least_factor, most_factor);
    for (std::size_t v = 0; v < flags_.size(); ++v) {
      if (counts(v)) velocities_[v] = mean + factor * (velocities_[v] - mean);
    }
  }

  Balance balance() const { return evolution::balance(scene_.film.positions(), velocities_, masses_); }
  // Potential, when masses were spread.
  double energy() const { return energy_; }
  void store() { store_motion(scene_.film, masses_, velocities_); }

 private:
  bool counts(std::size_t v) const { return flags_[v] != 0 && free_[v] != 0; }

  Scene& scene_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint8_t> free_;
  std::vector<double> masses_;
  std::vector<Vec3> velocities_;
  double energy_ = 0;
};

}  // namespace

TopologyKeeper::TopologyKeeper(bool keeps_energy)
    : keeps_energy_(keeps_energy), proximity_(contact, near_margin) {
  options_.mesh.least_move = evened_from;
}

void TopologyKeeper::take_up(TopologyMemory& memory, const Film& film) {
  if (memory.position_revision != film.position_revision()) return;
  watch_ = std::move(memory.watch);
  way_before_ = memory.way;
  memory = {};
}

void TopologyKeeper::leave(TopologyMemory& memory, const Film& film) {
  memory.watch = std::move(watch_);
  memory.position_revision = film.position_revision();
  memory.way = way_before_;
  for (const double reach : reaches_) memory.way = std::max(memory.way, way_before_ + reach);
}

bool TopologyKeeper::begin(Scene& scene) {
  surgery::keep_sizes(scene.film);
  if (surgery::needs_look(scene, options_)) return false;
  note_place(scene.film);
  return true;
}

void TopologyKeeper::note_place(const Film& film) {
  seen_.assign(film.positions().begin(), film.positions().end());
  reaches_.assign(seen_.size(), 0);
  sizes_.resize(seen_.size());
  smallest_size_ = HUGE_VAL;
  for (std::uint32_t v = 0; v < sizes_.size(); ++v) {
    sizes_[v] = surgery::size_of(film, Vertex(v));
    if (film.first_end(Vertex(v)).valid()) smallest_size_ = std::min(smallest_size_, sizes_[v]);
  }
  unseen_way_ = way_left_ = 0;
}

bool TopologyKeeper::is_mending_due(const Film& film) const {
  const std::span<const Vec3> positions = film.positions();
  if (mended_.size() != positions.size()) return true;
  const auto sizes = film.columns(ElementKind::vertex).reals(surgery::size_column);
  for (std::uint32_t v = 0; v < mended_.size(); ++v) {
    const double most = mend_after * sizes[v];
    if (squared_length(positions[v] - mended_[v]) > most * most) return true;
  }
  return surgery::has_narrow_wedges(film, options_) ||
         (!far_out_ && surgery::is_far_out_of_band(film, options_));
}

bool TopologyKeeper::is_due(std::span<const Vec3> positions, double largest_move, bool at_end) {
  if (seen_.size() != positions.size()) return true;
  // Where a vertex has been in the meantime is no farther off than this from where it is.
  const double meantime = unseen_way_ > 0 ? unseen_way_ + largest_move : 0;
  unseen_way_ += largest_move;
  if (!at_end && unseen_way_ < way_left_) return false;
  const double part = at_end ? look_at_end : tight_ ? look_after_tight : look_after;
  double farthest = 0;  // in sizes
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double way = length(positions[v] - seen_[v]);
    reaches_[v] = std::max(reaches_[v], way + meantime);
    farthest = std::max(farthest, way / sizes_[v]);
  }
  unseen_way_ = 0;
  way_left_ = std::max(0.0, part - farthest) * smallest_size_;
  return farthest > part;
}

std::vector<surgery::Tangle> TopologyKeeper::tangles(const Film& film) {
  for (double& reach : reaches_) reach += way_before_;
  way_before_ = 0;
  std::vector<surgery::Tangle> found = watch_.look(film, reaches_);
  std::fill(reaches_.begin(), reaches_.end(), 0.0);
  return found;
}

bool TopologyKeeper::look(Scene& scene, bool sound, bool mend) {
  ++counts_.looks;
  Film& film = scene.film;
  if (film.periodic()) return false;
  if (!surgery::has_sizes(film)) surgery::keep_sizes(film);
  if (!watch_.has_looked_at(film)) watch_.look(film);
  proximity_.update(film, watch_.near_pairs());
  const std::span<const surgery::Contact> contacts = proximity_.contacts();
  bool changed = false;
  tight_ = false;
  waits_ = !mend && !is_mending_due(film);
  const bool mends = !waits_ && surgery::needs_look(scene, options_);
  if (!contacts.empty() || mends) {
    // Where all that is due would make the film pass through itself, a part of it may not. The last try is to
    // slow down what touches and nothing else.
    surgery::TopologyOptions options = options_;
    const bool labelled = film::check_regions(film, 1).empty();
    for (const auto& [changes, upkeep] :
         {std::pair(true, true), {true, false}, {false, true}, {false, false}}) {
      const Scene before = scene;
      options.changes = changes;
      options.upkeep = upkeep && mends;
      options.tidy = upkeep;
      Pass pass = apply(scene, options, contacts, sound);
      if (pass.changed && is_fit(film, pass.report, sound, labelled)) {
        count(pass);
        changed = true;
        break;
      }
      scene = before;
      if (pass.report.changed()) {
        // A copy of what was known would cost every pass more than this costs the few that are thrown away.
        watch_.forget();
        watch_.look(film);
      }
      if (!pass.changed) break;
      ++counts_.refused;
    }
  }
  note_place(film);
  if (!waits_) {
    mended_ = seen_;
    far_out_ = mends && surgery::is_far_out_of_band(film, options_);
  }
  return changed;
}

void TopologyKeeper::count(Pass& pass) {
  const surgery::TopologyReport& report = pass.report;
  if (!report.changed()) return;
  ++counts_.passes;
  counts_.splits += report.mesh.splits;
  counts_.collapses += report.mesh.collapses;
  counts_.flips += report.mesh.flips;
  counts_.events += static_cast<long>(report.events.size());
  events_.insert(events_.end(), report.events.begin(), report.events.end());
}

// What holds vertices and the volumes. Of a film that is sound, what would pass through itself on the way
// stays where it is, and more and more around it.
TopologyKeeper::PutRight TopologyKeeper::put_right(Scene& scene, bool sound) {
  const Film& film = scene.film;
  if (!scene.has_fixed_volume() || film.triangle_count() == 0) {
    scene::constrain_vertices(scene);
    return {true, nullptr};
  }
  const Scene before = scene;
  std::vector<surgery::Tangle> held;
  for (int rings = 0; rings < most_rings_held; ++rings) {
    auto problem = held.empty() ? restored(scene) : restored_elsewhere(scene, held);
    if (problem == nullptr) return {};
    if (!sound) return {true, std::move(problem)};
    const std::vector<surgery::Tangle> tangles = watch_.look(film);
    if (tangles.empty()) return {true, std::move(problem)};
    for (const surgery::Tangle& tangle : tangles) held.push_back(surgery::grown(film, tangle, rings));
    scene = before;
  }
  return {};
}

// Whether a film is no worse than it was: sound, and labelled soundly.
bool TopologyKeeper::is_fit(const Film& film, const surgery::TopologyReport& report, bool sound,
                            bool labelled) {
  if (labelled && !report.events.empty() && !film::check_regions(film, 1).empty()) return false;
  return !sound || watch_.look(film).empty();
}

// Surgery, and then everything that it leaves to be put right. Where nothing is changed the scene is to be
// thrown away.
TopologyKeeper::Pass TopologyKeeper::apply(Scene& scene, const surgery::TopologyOptions& options,
                                           std::span<const surgery::Contact> contacts, bool sound) {
  Film& film = scene.film;
  film::Columns& columns = film.columns(ElementKind::vertex);
  if (film::Column* mass = columns.edit("mass")) mass->inheritance.on_merge = film::Inheritance::Merge::sum;
  if (film::Column* velocity = columns.edit("velocity"))
    velocity->inheritance.on_merge = film::Inheritance::Merge::mean;
  film.begin_rings_alike();  // a run that is continued from a file is the same run
  const Balance before = balance(scene);
  damp_mesh_noise(scene, noise_taken, keeps_energy_);
  double energy = keeps_energy_ ? potential_energy(scene) + balance(scene).kinetic : 0;
  Pass pass;
  surgery::TopologyReport& report = pass.report;
  report = surgery::keep_topology(scene, options, contacts);
  tight_ = !report.refused.empty();
  const double moving = balance(scene).kinetic;
  const bool slowed = slow_down(scene, report.refused);
  if (slowed) energy += balance(scene).kinetic - moving;
  pass.changed = slowed;
  if (!report.changed()) return pass;
  watch_.before_compaction(film);
  Touched touched(scene, compact_with_flags(film, report.touched));
  const PutRight right = put_right(scene, sound);
  if (!right.done) {
    ++counts_.refused;
    pass.changed = false;
    return pass;
  }
  if (right.with != nullptr) {
    touched.spread_mass(before.mass, right.with->energy());
  } else {
    energy::FilmEnergy terms(scene);
    touched.spread_mass(before.mass, terms);
  }
  touched.restore_momentum(before.momentum);
  if (keeps_energy_ && report.events.empty() && report.zips == 0)
    touched.add_kinetic(energy - touched.energy() - touched.balance().kinetic);
  touched.restore_angular_momentum(before.angular_momentum);
  touched.store();
  pass.changed = true;
  return pass;
}

// Sheets that touch and cannot merge lose the speed with which they approach, like bodies that collide
// without bouncing.
bool TopologyKeeper::slow_down(Scene& scene, std::span<const surgery::Contact> contacts) {
  bool slowed = false;
  Film& film = scene.film;
  for (const surgery::Contact& contact : contacts) {
    const auto& [vertex, facet] = contact.pair;
    if (!film.alive(vertex) || !film.alive(facet)) continue;
    // Surgery may have moved them since, or made them neighbours.
    const auto& corners = film.corners(facet);
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) continue;
    const std::array<Vec3, 3> points = film.points(facet);
    const Vec3 nearest = surgery::nearest_point(points, film.position(vertex));
    const Vec3 gap = nearest - film.position(vertex);
    const double distance = length(gap);
    const bool is_far = distance > hard_gap * surgery::size_of(film, vertex);
    if ((is_far && !contact.wedge) || distance <= 0) continue;
    film::Reals& v = reals(film, "velocity");
    const film::Reals& m = reals(film, "mass");
    const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
    const auto at = [&](Vertex w) { return Vec3{v[3 * w.index], v[3 * w.index + 1], v[3 * w.index + 2]}; };
    const Vec3 way = gap / distance;
    // One impulse along the way between vertex and facet, at the facet's nearest point: neither momentum is
    // lost. What is fixed, or has no mass, does not move.
    const std::array<double, 3> part = parts_at(points, nearest);
    const auto ease = [&](Vertex w) {
      const bool stays = m[w.index] <= 0 || (!fixed.empty() && fixed[w.index] != 0);
      return stays ? 0 : 1 / m[w.index];
    };
    Vec3 other;
    double inverse = ease(vertex);
    for (std::size_t k = 0; k < 3; ++k) {
      other += part[k] * at(corners[k]);
      inverse += part[k] * part[k] * ease(corners[k]);
    }
    const double approach = dot(at(vertex) - other, way);
    if (approach <= 0 || inverse <= 0) continue;
    const auto push = [&](Vertex w, double speed) {
      for (int axis = 0; axis < 3; ++axis)
        v[3 * w.index + static_cast<std::size_t>(axis)] += speed * way[axis];
    };
    const double impulse = approach / inverse;
    push(vertex, -impulse * ease(vertex));
    for (std::size_t k = 0; k < 3; ++k) push(corners[k], impulse * part[k] * ease(corners[k]));
    slowed = true;
  }
  return slowed;
}

double TopologyKeeper::longest_step(const Scene& scene, std::span<const Vec3> positions,
                                    std::span<const Vec3> velocities) const {
  double longest = HUGE_VAL;
  if (sizes_.size() != positions.size()) return longest;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double squared = squared_length(velocities[v]);
    if (longest == HUGE_VAL ? squared > 0
                            : squared * longest * longest > step_any * step_any * sizes_[v] * sizes_[v])
      longest = step_any * sizes_[v] / std::sqrt(squared);
  }
  if (!proximity_.belongs_to(scene.film)) return longest;
  for (const surgery::NearPair& pair : proximity_.pairs()) {
    for (const Vertex corner : scene.film.corners(pair.facet)) {
      const double speed = length(velocities[pair.vertex.index] - velocities[corner.index]);
      if (speed > 0) longest = std::min(longest, step_near * sizes_[pair.vertex.index] / speed);
    }
  }
  return longest;
}

}  // namespace lamella::evolution
