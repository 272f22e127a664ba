// Surgery on a film in motion: when to look, and what becomes of volumes, masses and velocities.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "evolution/balance.h"
#include "scene/scene.h"
#include "solve/problem.h"
#include "surgery/keep_topology.h"
#include "surgery/proximity.h"
#include "surgery/tangle_watch.h"

namespace lamella::evolution {

struct TopologyCounts {
  long passes = 0;  // that changed something
  long looks = 0;
  long splits = 0;
  long collapses = 0;
  long flips = 0;
  long events = 0;
  long refused = 0;  // passes thrown away: volumes could not be restored
};

// What one motion knows of how far a film's facets are from meeting, for the next that goes on from there. It
// changes nothing that is done, and saves searching the whole film at the first look.
struct TopologyMemory {
  surgery::TangleWatch watch;
  std::uint64_t position_revision = 0;  // of the film that it belongs to
  double way = 0;                       // of vertices since the last look, at most
};

// What a motion keeps from step to step to know when something may have come together. A film that has moved
// by less than a twentieth of its mesh's size since the last look is not looked at; one that lies within the
// band, with its sheets apart, is not touched.
class TopologyKeeper {
 public:
  // What the mesh's changes cost of energy is given back to velocities, or lost, as interpolation leaves it.
  explicit TopologyKeeper(bool keeps_energy = true);

  // Where the film is as the motion before left it.
  void take_up(TopologyMemory& memory, const film::Film& film);
  // After the end of a motion, whose end the film has been put to.
  void leave(TopologyMemory& memory, const film::Film& film);
  // At the start of a motion: false if the mesh alone says that a look is due.
  bool begin(scene::Scene& scene);
  // Whether the film has moved so far since the last look that it is time for one; at the end of a motion
  // that is nearly any way. No vertex has moved by more than `largest_move` since the last call: vertices are
  // gone through only where that may have brought one of them far enough.
  bool is_due(std::span<const Vec3> positions, double largest_move, bool at_end);
  // Where the film passes through itself, or has done since the last call; not for periodic films. A film
  // that is sound, or goes back to where it was, is watched on from there.
  std::vector<surgery::Tangle> tangles(const film::Film& film);
  // The film goes on from somewhere else, or is not sound.
  void forget_way() { watch_.forget(); }
  // The film was taken back to where it was sound: it is watched on from there, even if this is the first
  // that is seen of it.
  void resume(const film::Film& film) {
    if (!watch_.knows_film()) watch_.look(film);
  }
  // A look at a compact film with the vertex columns "velocity" and "mass". Makes what is due: the mesh, the
  // topology, the regions; volumes are restored by positions alone, total mass and (where no vertex is
  // fixed) momentum stay exactly; energy lost or won by the mesh is given back to the velocities around.
  // Of a film that is `sound`, nothing is changed that would make it pass through itself. What can wait does
  // so until a vertex has moved by a quarter of its mesh's size, or to the end. Returns whether the film or
  // its velocities changed; it is compact again.
  bool look(scene::Scene& scene, bool sound, bool mend);
  // Whether something may have waited at the last look.
  bool waits() const { return waits_; }

  // The longest step that moves sheets that are near one another by no more than a part of the gap allowed,
  // and any vertex by no more than a part of its mesh's size.
  double longest_step(const scene::Scene& scene, std::span<const Vec3> positions,
                      std::span<const Vec3> velocities) const;

  const TopologyCounts& counts() const { return counts_; }
  // Events since the last call.
  std::vector<surgery::Event> take_events() { return std::move(events_); }

 private:
  struct Pass {
    bool changed = false;
    surgery::TopologyReport report;
  };
  Pass apply(scene::Scene& scene, const surgery::TopologyOptions& options,
             std::span<const surgery::Contact> contacts, bool sound);
  void count(Pass& pass);
  bool is_mending_due(const film::Film& film) const;
  void note_place(const film::Film& film);
  struct PutRight {
    bool done = false;
    std::unique_ptr<solve::Problem> with;  // null where there was nothing to restore
  };
  PutRight put_right(scene::Scene& scene, bool sound);
  bool is_fit(const film::Film& film, const surgery::TopologyReport& report, bool sound, bool labelled);
  bool slow_down(scene::Scene& scene, std::span<const surgery::Contact> contacts);

  bool keeps_energy_;
  surgery::TopologyOptions options_;
  surgery::Proximity proximity_;
  surgery::TangleWatch watch_;
  bool tight_ = false;  // sheets touch that cannot merge: looks are frequent then
  std::vector<Vec3> seen_;
  std::vector<double> reaches_;  // how far vertices have been from there since
  double way_before_ = 0;        // of any vertex from the watch's last look to the start of this motion
  double unseen_way_ = 0;        // of any vertex since they were gone through
  double way_left_ = 0;          // and what it may be before they are again
  std::vector<Vec3> mended_;     // where the film was when all was mended that could be
  bool waits_ = false;
  bool far_out_ = false;  // and what could not is far out of its band: not tried again before it is time
  std::vector<double> sizes_;
  double smallest_size_ = 0;
  TopologyCounts counts_;
  std::vector<surgery::Event> events_;
};

}  // namespace lamella::evolution
