#include "energy/plateau.h"

#include "session/session.h"

namespace lamella::session::commands {

namespace {

void print_row(Session& session, std::string_view name, const energy::AngleDeviation& deviation) {
  if (deviation.angles == 0) {
    session.print("{:<26} {:>8}\n", name, "none");
  } else {
    session.print("{:<26} {:8} {:12.4f} {:12.4f}\n", name, deviation.angles, deviation.rms, deviation.worst);
  }
}

void run(Session& session) {
  const energy::PlateauAngles angles = energy::plateau_angles(session.scene().film);
  session.print("{:<26} {:>8} {:>12} {:>12}\n", "degrees off Plateau's laws", "angles", "rms", "worst");
  print_row(session, "triple lines (120)", angles.triple);
  print_row(session, "quad points (109.4712)", angles.quad);
  if (angles.other_borders > 0)
    session.print("edges of more than three films: {} (unstable)\n", angles.other_borders);
  if (angles.other_points > 0)
    session.print("points where borders meet otherwise than four by four: {}\n", angles.other_points);
}

}  // namespace

extern const Command plateau_command =
    make_command({.name = "plateau",
                  .summary = "how far angles at borders and quad points are from Plateau's laws",
                  .group = CommandGroup::measure},
                 run);

}  // namespace lamella::session::commands
