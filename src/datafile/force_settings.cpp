#include "datafile/force_settings.h"

#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "datafile/write_commands.h"
#include "language/formula_scope.h"
#include "language/lexer.h"

namespace lamella::datafile {

namespace {

using scene::VectorFormula;

VectorFormula parsed(Reading& reading, const language::Token& name, const std::string& text) {
  language::LexerStream tokens(
      language::Lexer(text::make_source(std::string(name.text), text), language::LexerMode::command));
  VectorFormula result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.component[axis] = language::parse_formula(tokens, language::FormulaKind::space,
                                                     reading.scene.variables, scene::vertex_state_names);
    const bool last = axis == 2;
    if (last ? tokens.peek().is(language::TokenKind::end) : tokens.peek().is_symbol(",")) {
      tokens.take();
      continue;
    }
    throw text::Error(name.place, fmt::format("\"{}\" is three formulas", name.text),
                      "as in parameter lamella_force = \"0, 0, -1\"");
  }
  return result;
}

scene::Air& air_of(Reading& reading) {
  std::optional<scene::Air>& air = reading.scene.forces.air;
  if (!air) air.emplace();
  return *air;
}

void read_air(Reading& reading, const language::Token& name, const std::string& text) {
  scene::Air& air = air_of(reading);
  std::istringstream in(text);
  in >> air.cells >> air.from.x >> air.from.y >> air.from.z >> air.to.x >> air.to.y >> air.to.z >>
      air.viscosity >> air.pressure;
  if (in && air.cells > 1 && air.to.x > air.from.x && air.to.y > air.from.y && air.to.z > air.from.z) return;
  throw text::Error(name.place, fmt::format("\"{}\" is no box of air", name.text),
                    "cells, two corners, viscosity and pressure, as in \"32 -2 -2 -2 2 2 2 0 1\"");
}

void put_parameter(std::string& out, const char* name, const std::string& text) {
  fmt::format_to(std::back_inserter(out), "parameter {} = {}\n", name, written_value(text));
}

}  // namespace

bool read_force_setting(Reading& reading, const language::Token& name, const std::string& text) {
  scene::Forces& forces = reading.scene.forces;
  if (name.is_word("lamella_force")) {
    forces.force = parsed(reading, name, text);
  } else if (name.is_word("lamella_wind")) {
    forces.wind = parsed(reading, name, text);
  } else if (name.is_word("lamella_air")) {
    read_air(reading, name, text);
  } else if (name.is_word("lamella_air_fan")) {
    air_of(reading).fan = parsed(reading, name, text);
  } else if (name.is_word("lamella_air_jet")) {
    air_of(reading).jet = parsed(reading, name, text);
  } else {
    return false;
  }
  return true;
}

void write_forces(std::string& out, const scene::Forces& forces) {
  if (forces.force) put_parameter(out, "lamella_force", forces.force->text());
  if (forces.wind) put_parameter(out, "lamella_wind", forces.wind->text());
  if (!forces.air) return;
  const scene::Air& air = *forces.air;
  put_parameter(out, "lamella_air",
                fmt::format("{} {} {} {} {} {} {} {} {}", air.cells, air.from.x, air.from.y, air.from.z,
                            air.to.x, air.to.y, air.to.z, air.viscosity, air.pressure));
  if (air.fan) put_parameter(out, "lamella_air_fan", air.fan->text());
  if (air.jet) put_parameter(out, "lamella_air_jet", air.jet->text());
}

}  // namespace lamella::datafile
