#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  for (const char* const name : {"edge_delete_count",
                                 "facet_delete_count",
                                 "edgeswap_count",
                                 "notch_count",
                                 "equi_count",
                                 "fix_count",
                                 "unfix_count",
                                 "refine_count",
                                 "edge_refine_count",
                                 "facet_refine_count",
                                 "vertex_dissolve_count",
                                 "edge_dissolve_count",
                                 "facet_dissolve_count",
                                 "body_dissolve_count",
                                 "vertex_pop_count",
                                 "edge_pop_count",
                                 "pop_count",
                                 "pop_edge_to_tri_count",
                                 "pop_tri_to_edge_count",
                                 "burst_count"}) {
    session.counter(name) = 0;
  }
}

}  // namespace

extern const Command reset_counts_command =
    make_command({.name = "reset_counts",
                  .aliases = {"flush_counts"},
                  .summary = "set the counters that commands leave behind to 0",
                  .group = CommandGroup::session},
                 run);

}  // namespace lamella::session::commands
