#include "solve/reactions.h"

#include "session/session.h"

namespace lamella::session::commands {

namespace {

constexpr double shown = 5e-9;  // less is printed as zero, without a sign

std::string name_of(const film::Film& film, const solve::Reaction& reaction) {
  if (reaction.holder == solve::Holder::wire)
    return fmt::format("wire at vertex {}", film.number(reaction.first));
  if (reaction.holder == solve::Holder::boundary) return fmt::format("boundary {}", reaction.numbers[0]);
  return fmt::format("constraint{} {}", reaction.numbers.size() > 1 ? "s" : "",
                     fmt::join(reaction.numbers, " and "));
}

void print_row(Session& session, std::string_view name, std::uint32_t vertices, const film::Vec3& pull) {
  session.print("{:<24} {:8}", name, vertices);
  for (const double number : {pull.x, pull.y, pull.z, film::length(pull)})
    session.print(" {:14.8f}", std::abs(number) < shown ? 0.0 : number);
  session.print("\n");
}

void run(Session& session) {
  const auto found = solve::reactions(session.scene());
  if (!found) {
    throw text::Error("the forces on the film are not finite, or its volumes depend on one another",
                      "look for degenerate facets: list facets where area < 1e-12");
  }
  const std::vector<solve::Reaction>& reactions = *found;
  if (reactions.empty()) {
    session.print("nothing holds the film\n");
    return;
  }
  session.print("{:<24} {:>8} {:>14} {:>14} {:>14} {:>14}\n", "the film pulls on", "vertices", "x", "y", "z",
                "length");
  film::Vec3 sum;
  std::uint32_t vertices = 0;
  for (const solve::Reaction& reaction : reactions) {
    print_row(session, name_of(session.scene().film, reaction), reaction.vertices, reaction.pull);
    sum += reaction.pull;
    vertices += reaction.vertices;
  }
  print_row(session, "all together", vertices, sum);
}

}  // namespace

extern const Command reactions_command =
    make_command({.name = "reactions",
                  .summary = "forces of the film on wires, boundaries and constraints",
                  .group = CommandGroup::measure},
                 run);

}  // namespace lamella::session::commands
