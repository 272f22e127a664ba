// What the parts of the reader share while one datafile is read.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "datafile/findings.h"
#include "datafile/rows.h"
#include "datafile/token_source.h"
#include "scene/scene.h"

namespace lamella::datafile {

// Surface tensions by pairs of phases, the smaller number first.
struct Phases {
  std::map<std::pair<int, int>, double> tensions;
};

struct Reading {
  explicit Reading(text::SourcePointer file) : tokens(std::move(file)) {}

  TokenSource tokens;
  Findings findings;
  scene::Scene scene;  // settings and variables; the film comes last
  Rows rows;
  std::vector<text::Place> procedures;  // of the top section, from their first word to the closing brace
  std::optional<std::array<film::Vec3, 3>> periods;  // of a periodic film
  bool wraps_are_attributes = false;                 // of edges, in place of signs
  text::Place dimension_place;                       // where that of space was given
  std::optional<Phases> phases;
  bool keep_originals = false;  // elements keep their numbers
  bool keep_macros = false;     // macros stay in force in the commands after `read`
  std::map<std::string, text::Place, std::less<>> defined;  // where each variable was, by lower-case name
  // Numbers of constraints and boundaries that have names, in lower case.
  std::map<std::string, int, std::less<>> constraint_names;
  std::map<std::string, int, std::less<>> boundary_names;
  std::vector<scene::MethodInstance> method_instances;  // that have names
  std::set<std::string_view> refused;                   // what was found that is not supported

  // Says once for each feature that it is not supported. `word` is what stands in the file, `feature` what it
  // is about.
  void refuse(const text::Place& place, std::string_view word, std::string_view feature);

  // Runs one step; a mistake in it is noted, and then `recover()` finds the place to go on.
  template <class Step, class Recover>
  void attempt(Step&& step, Recover&& recover) {
    try {
      step();
    } catch (const Unreadable&) {
      throw;
    } catch (const language::Incomplete&) {
      throw;
    } catch (const text::Error& error) {
      // What comes after a feature that is not supported may be wrong for that reason.
      if (refused.empty()) findings.take(error);
      recover();
    }
  }
};

}  // namespace lamella::datafile
