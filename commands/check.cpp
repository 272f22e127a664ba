#include "film/check.h"

#include "film/intersections.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  const film::Film& film = session.scene().film;
  std::vector<text::Diagnostic> findings;
  for (const std::string& finding : film::check(film))
    findings.push_back({text::Severity::error, {}, finding, {}, {}});
  if (findings.empty()) {
    for (const auto& [a, b] : film::self_intersections(film)) {
      findings.push_back(
          {text::Severity::error,
           {},
           fmt::format("facets {} and {} pass through one another, or touch", film.number(a), film.number(b)),
           {},
           {}});
    }
  }
  session.counter("check_count") = static_cast<double>(findings.size());
  if (!findings.empty()) throw text::Error(std::move(findings));
  // A body that its films do not close is lawful, so what it does to the labels is only told.
  for (const std::string& finding : film::check_regions(film, 5)) session.tell("note: {}\n", finding);
  session.tell("Checks completed.\n");
}

}  // namespace

extern const Command check_command = make_command({.name = "check",
                                                   .aliases = {"C"},
                                                   .summary = "test every invariant of the film complex",
                                                   .group = CommandGroup::measure},
                                                  run);

}  // namespace lamella::session::commands
