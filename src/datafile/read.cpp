#include "datafile/read.h"

#include <algorithm>
#include <string_view>

#include "datafile/assemble.h"
#include "datafile/body_check.h"
#include "datafile/element_constraints.h"
#include "datafile/elements.h"
#include "datafile/include_files.h"
#include "datafile/oddities.h"
#include "datafile/phases.h"
#include "datafile/reading.h"
#include "datafile/resolve.h"
#include "datafile/title.h"
#include "datafile/top_section.h"
#include "scene/constraint_sets.h"

namespace lamella::datafile {

namespace {

class DatafileReader {
 public:
  DatafileReader(const text::SourcePointer& file, const language::Variables* session)
      : file_(file), reading_(file) {
    reading_.scene.strings = scene::make_string_model();
    if (session != nullptr) reading_.scene.variables.restart_like(*session);
    reading_.scene.name = file->name;
    reading_.scene.title = title_of(file->content);
  }

  ReadResult read();

 private:
  text::Place beginning() const { return {file_, 0, 0}; }
  bool parse();
  void check_and_assemble();
  void stop_if_wrong() const;

  text::SourcePointer file_;
  Reading reading_;
  bool at_read_ = false;
};

// Whether all was read that can be read.
bool DatafileReader::parse() {
  try {
    read_top_section(reading_);
    const scene::StringModel& strings = reading_.scene.strings;
    if (strings.dimension == 2 && !strings.on)
      reading_.refuse(reading_.dimension_place, "space_dimension", "facets in a plane");
    // Lists look different where a feature is used that is not supported.
    if (!reading_.refused.empty()) return false;
    at_read_ = read_lists(reading_);
  } catch (const text::Error& error) {
    reading_.findings.take(error);
    return false;
  }
  return !reading_.findings.too_many();
}

void DatafileReader::check_and_assemble() {
  place_on_boundaries(reading_);
  const Resolved resolved = resolve(reading_);
  const std::vector<film::Region> regions = number_bodies(reading_);
  const std::vector<film::RegionPair> face_regions = check_bodies(reading_, resolved, regions);
  warn_of_oddities(reading_, resolved);
  stop_if_wrong();
  assemble(reading_, resolved, regions, face_regions);
  apply_phases(reading_);
  bind_formulas(reading_.scene);
}

void DatafileReader::stop_if_wrong() const {
  if (reading_.findings.has_errors())
    throw text::Error(reading_.findings.in_order(reading_.tokens.sources()));
}

bool is_blank(std::string_view content) {
  return content.find_first_not_of(" \t\r\n\f\x1a") == std::string_view::npos;
}

ReadResult DatafileReader::read() {
  if (is_blank(file_->content)) throw text::Error(beginning(), "the datafile is empty");
  const bool complete = parse();
  if (!complete) stop_if_wrong();
  if (reading_.rows.positions.empty() && !reading_.findings.has_errors()) {
    throw text::Error(beginning(), "there are no vertices in this datafile",
                      "the lists of a datafile begin with vertices, edges, faces and bodies");
  }
  check_and_assemble();
  ReadResult result;
  result.warnings = reading_.findings.in_order(reading_.tokens.sources());
  if (at_read_) result.read_section = reading_.tokens.take_rest(reading_.keep_macros);
  result.procedures = std::move(reading_.procedures);
  result.scene = std::move(reading_.scene);
  return result;
}

}  // namespace

ReadResult read_datafile(const text::SourcePointer& file, const language::Variables* session) {
  return DatafileReader(file, session).read();
}

ReadResult read_datafile(const std::string& path, const language::Variables* session) {
  return read_datafile(read_text(path), session);
}

}  // namespace lamella::datafile
