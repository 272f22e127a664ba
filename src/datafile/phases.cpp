#include "datafile/phases.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "datafile/include_files.h"

namespace lamella::datafile {

using film::ElementKind;

namespace {

double tension_between(const Phases& phases, int a, int b) {
  const auto at = phases.tensions.find(std::minmax(a, b));
  return at == phases.tensions.end() ? 1 : at->second;
}

// Where the file says nothing of a tension the column may be missing.
film::Column& tension_column(film::Columns& columns) {
  if (columns.find("tension") == nullptr) columns.add(film::real_column("tension", 1));
  return *columns.edit("tension");
}

void apply_to_facets(Reading& reading) {
  scene::Scene& scene = reading.scene;
  film::Column& tension = tension_column(scene.film.columns(ElementKind::facet));
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
    const film::RegionPair pair = scene.film.regions(film::Triangle(t));
    if (pair.front.index == 0 || pair.behind.index == 0) continue;
    tension.set(
        t, 0, tension_between(*reading.phases, scene.body(pair.front).phase, scene.body(pair.behind).phase));
  }
}

void apply_to_strings(Reading& reading) {
  scene::Scene& scene = reading.scene;
  film::Columns& columns = scene.film.columns(ElementKind::edge);
  const film::Column* const cells = columns.find(scene::cells_column);
  if (cells == nullptr || cells->width < 2) return;
  film::Column& tension = tension_column(columns);
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
    const auto phase = [&](int k) {
      const int cell = std::abs(static_cast<int>(cells->value(e, k)));
      return cell == 0 ? 0 : reading.rows.face_phases[static_cast<std::size_t>(cell) - 1];
    };
    if (cells->value(e, 1) != 0) tension.set(e, 0, tension_between(*reading.phases, phase(0), phase(1)));
  }
}

[[noreturn]] void refuse_line(const text::Place& place, const std::string& path, const std::string& line) {
  throw text::Error(place, fmt::format("\"{}\" has a line without a tension: {}", path, line),
                    "a line holds two numbers of phases and the surface tension between them");
}

}  // namespace

void read_phasefile(Reading& reading, const language::Token& word) {
  const language::Token name = reading.tokens.take();
  if (!name.is(language::TokenKind::string))
    throw text::Error(name.place, "the name of a file of phases stands in quotes",
                      "write phasefile \"file\"");
  const std::string& here = word.place.source->name;
  const std::optional<std::string> path = find_included(name.content, here, here);
  if (!path)
    throw text::Error(name.place, fmt::format("cannot find the file \"{}\"", name.content),
                      "it is looked for beside this file and in the folders of EVOLVERPATH");
  std::istringstream lines(read_text(*path)->content);
  std::string line;
  std::getline(lines, line);  // how many phases there are
  Phases phases;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    int a = 0;
    int b = 0;
    double tension = 0;
    if (!(words >> a >> b)) continue;  // a comment
    if (!(words >> tension) || !std::isfinite(tension)) refuse_line(name.place, *path, line);
    phases.tensions[std::minmax(a, b)] = tension;
  }
  reading.phases = std::move(phases);
}

void apply_phases(Reading& reading) {
  if (!reading.phases) return;
  reading.rows.face_phases.resize(reading.rows.of(ElementKind::facet).size());
  if (reading.scene.strings.on)
    apply_to_strings(reading);
  else
    apply_to_facets(reading);
}

}  // namespace lamella::datafile
