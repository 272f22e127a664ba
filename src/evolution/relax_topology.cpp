#include "evolution/relax_topology.h"

#include <algorithm>
#include <cmath>

#include "energy/mesh_quality.h"
#include "evolution/targets_on_the_way.h"
#include "film/box_tree.h"
#include "scene/constraint_sets.h"
#include "surgery/pop.h"
#include "surgery/regions.h"
#include "surgery/sizing.h"

namespace lamella::evolution {

namespace {

using scene::Scene;
using solve::Ending;

constexpr int most_rounds = 30;
constexpr int most_idle_rounds = 3;  // one after the other, in which the topology stays
// A wave crosses the film in its diameter's time (its speed is 1 at tension 1): damped over a sixth of that,
// what moves creeps, and still gets anywhere.
constexpr double damping_over_diameter = 6;
constexpr long spell = 50;                // steps between two looks at whether all is at rest
constexpr int most_spells = 12;           // in a round
constexpr double far_from_targets = 0.1;  // in parts of a volume
constexpr double rough_angle = 10 * M_PI / 180;
constexpr double at_rest = 1e-5;  // kinetic energy, as a part of the film's

double diameter(const film::Film& film) {
  const film::Box box = film::box_of(film.positions());
  return length(box.high - box.low);
}

// A spell of motion, from rest to rest, for which a scene's own time does not pass.
class MotionAside {
 public:
  explicit MotionAside(Scene& scene)
      : scene_(scene), time_(scene.time), work_(scene.work), damping_(scene.damping) {}
  MotionAside(const MotionAside&) = delete;
  MotionAside& operator=(const MotionAside&) = delete;
  ~MotionAside() {
    scene_.time = time_;
    scene_.work = work_;
    scene_.damping = damping_;
    for (const char* name : {"velocity", "mass"}) scene_.film.columns(film::ElementKind::vertex).remove(name);
  }

 private:
  Scene& scene_;
  double time_;
  double work_;
  double damping_;
};

// What motion leaves in a scene beside a film. Between spells it stays, so that the mesh keeps to its sizes.
class TracesOfMotion {
 public:
  explicit TracesOfMotion(Scene& scene)
      : scene_(scene),
        fitness_(scene.mesh_fitness),
        unkept_(scene.steps_unkept),
        had_sizes_(surgery::has_sizes(scene.film)) {}
  void wipe() {
    scene_.mesh_fitness = fitness_;
    scene_.steps_unkept = unkept_;
    film::Columns& vertices = scene_.film.columns(film::ElementKind::vertex);
    if (!had_sizes_) vertices.remove(surgery::size_column);
    vertices.remove("swept_place");
    for (const char* name : {"volume_defect", "swept_mark"}) scene_.body_columns.remove(name);
  }

 private:
  Scene& scene_;
  double fitness_;
  double unkept_;
  bool had_sizes_;
};

// Whether it may be the mesh alone that a film collapses by, in the first place.
bool is_rough(const Scene& scene) {
  return missing_volume(scene) > far_from_targets || energy::smallest_angle(scene.film) < rough_angle;
}

// Returns whether anything was popped.
bool pop_all(Scene& scene, const OnEvents& on_events) {
  surgery::PopReport report = surgery::pop_edges(scene, surgery::crowded_edges(scene.film));
  const surgery::PopReport points = surgery::pop_vertices(scene, surgery::illegal_vertices(scene));
  report.events.insert(report.events.end(), points.events.begin(), points.events.end());
  if (report.edges + report.vertices + points.edges + points.vertices == 0) return false;
  surgery::settle_regions(scene, report.events, {});
  scene.film.compact();
  scene::constrain_vertices(scene);
  if (on_events && !report.events.empty()) on_events(scene, report.events);
  return true;
}

// Where going down from a saddle leads to a collapse: the way there, to be gone in motion.
void go_past_saddle(Scene& scene, RelaxOptions options, scene::Monitor& monitor) {
  const Scene before = scene;
  options.leave_saddle = false;
  if (!relax(scene, options, monitor).converged() || !descend_from_saddle(scene, monitor)) scene = before;
}

// Returns how the motion ended; `changed` tells whether the topology has.
Ending creep(Scene& scene, scene::Monitor& monitor, const OnEvents& on_events, bool& changed) {
  MotionAside aside(scene);
  scene.damping = damping_over_diameter / diameter(scene.film);
  StepSize size;
  size.topology = true;
  bool busy = false;
  const OnEvents note = [&](Scene& now, std::span<const surgery::Event> events) {
    busy = changed = true;
    if (on_events) on_events(now, events);
  };
  TopologyMemory memory;
  Ending ending = Ending::step_limit;
  for (int i = 0; i < most_spells && ending == Ending::step_limit; ++i) {
    busy = false;
    const EvolveReport report = evolve(scene, spell, size, monitor, {}, note, &memory);
    ending = report.ending;
    if (!busy && report.kinetic < at_rest * report.energy) break;
  }
  return ending;
}

}  // namespace

RelaxReport relax_with_topology(Scene& scene, const RelaxOptions& options, scene::Monitor& monitor,
                                const OnEvents& on_events) {
  RelaxReport report;
  RelaxOptions wanted = options;
  wanted.new_meshes = options.new_meshes && is_rough(scene);
  TracesOfMotion traces(scene);
  bool has_moved = false;
  int idle = 0;
  for (int round = 0; round < most_rounds && !scene.empty(); ++round) {
    const Scene before = scene;
    report = relax(scene, wanted, monitor);
    if (report.ending == Ending::stopped) break;
    if (report.converged()) {
      if (report.crowded == 0 || !pop_all(scene, on_events)) break;
      continue;
    }
    scene = before;
    wanted.new_meshes = false;  // where the film still collapses the mesh is mended in motion
    if (pop_all(scene, on_events)) continue;
    // At a saddle nothing would move.
    if (report.saddles_left > 0) go_past_saddle(scene, wanted, monitor);
    has_moved = true;
    bool changed = false;
    const Ending ending = creep(scene, monitor, on_events, changed);
    if (ending == Ending::stopped) {
      report.ending = ending;
      break;
    }
    idle = changed ? 0 : idle + 1;
    if (idle == most_idle_rounds) break;
  }
  if (has_moved) traces.wipe();
  return report;
}

}  // namespace lamella::evolution
