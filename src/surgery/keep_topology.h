// One pass over a film in motion: the mesh brought into its band, and every change of topology made that is
// due and lowers the energy.
#pragma once

#include "scene/scene.h"
#include "surgery/event.h"
#include "surgery/proximity.h"
#include "surgery/remesh.h"

namespace lamella::surgery {

struct TopologyOptions {
  RemeshOptions mesh;
  bool changes = true;  // of topology
  bool upkeep = true;   // of the mesh; what stands in its way is not looked for without
  bool tidy = true;     // upkeep where the topology has changed
  double narrow_wedge = 25 * 3.141592653589793 / 180;  // films at a border that are nearer are zipped up
  double gain = 1e-3;  // least energy that an automatic change must win, in units of tension times size^2
};

struct TopologyReport {
  RemeshReport mesh;
  std::vector<Event> events;
  std::vector<film::Vertex> touched;  // some removed since; a few twice
  std::vector<Contact> refused;       // contacts that could not be merged
  long zips = 0;
  bool bounded = false;  // something waits for the next pass because a bound was met

  bool changed() const { return mesh.operations() > 0 || zips > 0 || !events.empty(); }
};

// Whether a look at the mesh alone says that something is due.
bool needs_look(const scene::Scene& scene, const TopologyOptions& options);
// Whether films at a border are about to close on each other.
bool has_narrow_wedges(const film::Film& film, const TopologyOptions& options);
// Whether edges or angles are so far out of their band that it must not wait.
bool is_far_out_of_band(const film::Film& film, const TopologyOptions& options);

// The film keeps tombstones and rows; regions are brought up to date. Where nothing is reported the film is
// as it was, to the bit. Rounds and commits are bounded; what is left waits for the next pass.
TopologyReport keep_topology(scene::Scene& scene, const TopologyOptions& options,
                             std::span<const Contact> contacts = {});

}  // namespace lamella::surgery
