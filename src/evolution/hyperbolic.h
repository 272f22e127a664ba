// Hyperbolic geometric flow: films that move under their tension, volumes kept.
//
// After S. Ishida, M. Yamamoto, R. Ando, T. Hachisuka, "A Hyperbolic Geometric Flow for Evolving Films and
// Foams", ACM Transactions on Graphics 36(6), 2017: each vertex is accelerated by minus the gradient of the
// surface energy over its mass, dx^2/dt^2 = -(1/m) dE/dx, a symplectic Euler step is taken, and positions and
// velocities are corrected so that closed regions keep their volumes. Two things depart from the paper's
// Algorithm 1, for energy and momentum:
//
//   - vertices carry their mass (their share of the area when motion began) instead of taking it from the
//   current area;
//   - the correction acts along the exact volume gradients at the start of the step (as SHAKE does in
//   molecular
//     dynamics) instead of along averaged normals at its end.
//
// The tool's tension is sigma = 1 per facet unless the datafile says otherwise; the paper's beta is 2 sigma
// with its operator's factor 1/2, so both move alike. Mass is area times a density of 1.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "energy/film_energy.h"
#include "evolution/motion.h"
#include "evolution/topology.h"
#include "scene/monitor.h"
#include "scene/scene.h"
#include "solve/gram_solver.h"
#include "solve/problem.h"

namespace lamella::evolution {

using film::Vec3;

struct StepSize {
  std::optional<double> fixed;  // in units of time; larger ones than the bound are made in substeps
  double fraction = 0.5;        // of the stability bound, where not fixed; ten times as much if implicit
  Method method = Method::euler;
  VolumeMode volumes = VolumeMode::automatic;
  bool upkeep = true;       // keep the mesh fit where it would choke the steps
  bool keep_energy = true;  // what a change of the mesh costs goes into the velocities around it
  bool topology = false;    // keep edges within their band, and let films merge, pinch and swap neighbours
};

struct EvolveReport {
  solve::Ending ending = solve::Ending::step_limit;
  long steps = 0;     // as asked for
  long substeps = 0;  // as made
  long undone = 0;    // steps taken back and halved
  long upkeeps = 0;   // times that the mesh was made fit
  long retreats = 0;  // times that films had passed through one another, and were taken back
  double smallest_dt = 0;
  double largest_dt = 0;
  double bound = 0;   // the last stability bound
  double energy = 0;  // potential energy at the end
  double kinetic = 0;
  double volume_error = 0;  // largest relative error at the end
  StepTimes times;
  TopologyCounts topology;
};

// Moves the film by `steps` steps. Positions, the vertex columns "velocity" and "mass", the time and the
// pressures of the scene follow. Stops between steps (or the parts of one) when the monitor asks. If a step
// cannot be made even after halving it repeatedly, the film stays in its last valid state and the ending says
// why.
// `after_step`, where given, is called after each of the steps with the motion, whose scene has the step's
// time.
using AfterStep = std::function<void(Motion& motion, long step)>;
// `on_events`, where given, is called when films have changed their topology, and may change the scene.
using OnEvents = std::function<void(scene::Scene& scene, std::span<const surgery::Event> events)>;
// `memory`, where given, spares motions that follow one another searching the whole film for films that
// touch.
EvolveReport evolve(scene::Scene& scene, long steps, const StepSize& size, scene::Monitor& monitor,
                    const AfterStep& after_step = {}, const OnEvents& on_events = {},
                    TopologyMemory* memory = nullptr);

// The largest step for which linear theory promises stability at the scene's present shape: 2/sqrt(max
// s_v/m_v), with s_v the stiffness sum of the vertex (energy/sweep.h).
double stability_bound(const scene::Scene& scene, Method method = Method::euler);

}  // namespace lamella::evolution
