#include "evolution/volume_memory.h"

#include <algorithm>
#include <cmath>

namespace lamella::evolution {

namespace {

constexpr const char* column_name = "volume_defect";
constexpr int width = 4;  // last, before, miss, rate: the last the same for all
constexpr double smooth_slope = 0.3;
constexpr double rounding = 1e-13;  // of a volume

}  // namespace

VolumeMemory::VolumeMemory(const scene::Scene& scene, std::vector<film::Region> regions)
    : regions_(std::move(regions)), rows_(regions_.size()) {
  const film::Column* const column = scene.body_columns.find(column_name);
  const bool known = column != nullptr && column->width == width;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::uint32_t body = regions_[i].index - 1;
    if (known) {
      rows_[i] = {column->value(body, 0), column->value(body, 1), column->value(body, 2)};
      if (column->value(body, 3) > 0) rate_ = column->value(body, 3);
    }
    if (rows_[i].last == 0 && rows_[i].before == 0) rows_[i].miss = HUGE_VAL;
  }
  finish();
}

double VolumeMemory::expected(std::size_t row, double dt) const {
  const Row& r = rows_[row];
  const double slope = r.last - r.before;
  const bool smooth = std::abs(slope) < smooth_slope * std::abs(r.last);
  return dt * dt * (smooth ? r.last + slope : r.last);
}

void VolumeMemory::note(std::size_t row, double dt, double left, double missed, double volume) {
  Row& r = rows_[row];
  r.miss = std::isfinite(r.miss) ? std::max(std::abs(missed), 0.5 * r.miss) : std::abs(missed);
  if (std::abs(left) < rounding * volume) return;  // a step too short to tell
  r.before = r.last;
  r.last = left / (dt * dt);
}

void VolumeMemory::distrust(double miss) {
  for (Row& row : rows_) row.miss = std::max(row.miss, miss);
  finish();
}

void VolumeMemory::finish() {
  miss_ = 0;
  for (const Row& row : rows_) miss_ = std::max(miss_, row.miss);
}

void VolumeMemory::store(scene::Scene& scene) const {
  if (rows_.empty()) return;
  scene.body_columns.resize(scene.bodies.size());
  film::Column* column = scene.body_columns.edit(column_name);
  if (column == nullptr || column->width != width)
    column = &scene.body_columns.add(film::real_column(column_name, 0, width));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::uint32_t body = regions_[i].index - 1;
    column->set(body, 0, rows_[i].last);
    column->set(body, 1, rows_[i].before);
    column->set(body, 2, std::isfinite(rows_[i].miss) ? rows_[i].miss : 0);
    column->set(body, 3, rate_);
  }
}

}  // namespace lamella::evolution
