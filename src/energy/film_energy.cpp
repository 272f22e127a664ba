#include "energy/film_energy.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "energy/periodic_volume.h"
#include "scene/constraint_sets.h"

namespace lamella::energy {

namespace {

using film::ElementKind;

bool labelled(std::span<const film::RegionPair> regions) {
  return std::any_of(regions.begin(), regions.end(),
                     [](const film::RegionPair& pair) { return pair.front != pair.behind; });
}

std::vector<int> rows_of(std::span<const film::Region> regions, std::size_t slots) {
  std::vector<int> rows(slots, -1);
  for (std::size_t i = 0; i < regions.size(); ++i) rows[regions[i].index] = static_cast<int>(i);
  return rows;
}

std::vector<film::Region> regions_where(const scene::Scene& scene, auto&& wanted) {
  std::vector<film::Region> regions;
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    if (wanted(scene.bodies[b])) regions.push_back(film::Region{b + 1});
  }
  return regions;
}

// In a periodic film bodies may fill all of space: the volumes of all but one tell that of the last.
bool fills_space(const scene::Scene& scene) {
  if (!scene.film.periodic() || scene.bodies.empty()) return false;
  const auto& pairs = scene.film.connectivity().triangle_regions;
  const auto outside = [](const film::RegionPair& pair) {
    return pair.front != pair.behind &&
           (pair.front == film::outside_region || pair.behind == film::outside_region);
  };
  return std::none_of(pairs.begin(), pairs.end(), outside) &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const scene::Body& body) { return body.absent || body.fixed_volume(); });
}

std::vector<film::Region> constrained_regions(const scene::Scene& scene) {
  if (!scene.keep_volumes) return {};
  std::vector<film::Region> regions =
      regions_where(scene, [](const scene::Body& body) { return body.fixed_volume(); });
  if (!regions.empty() && fills_space(scene)) regions.pop_back();
  return regions;
}

std::vector<film::Region> pressurised_regions(const scene::Scene& scene) {
  return regions_where(scene, [](const scene::Body& body) { return body.fixed_pressure && !body.absent; });
}

// The scene without positions (they are arguments; holding them would only cost memory), its formulas bound.
scene::Scene prepared(const scene::Scene& scene) {
  scene::Scene result = scene;
  result.film.edit_position_rows() = {};
  scene::bind_formulas(result);
  return result;
}

}  // namespace

FilmEnergy::FilmEnergy(const scene::Scene& scene)
    : scene_(prepared(scene)),
      vertex_count_(scene.film.vertex_rows()),
      unfolding_(scene.film.periodic() ? film::Unfolding(scene.film) : film::Unfolding{}),
      open_volume_(scene.symmetric_content ? OpenVolume::cone_from_origin : OpenVolume::above_plane),
      constraints_(scene),
      energy_edges_(energy::energy_edges(scene_)),
      content_edges_(energy::content_edges(scene_)),
      gaps_(gap_edges(scene_)),
      boundary_gaps_(boundary_gap_edges(scene_)),
      heavy_(heavy_facets(scene)),
      volumes_(scene.bodies.size() + 1),
      lines_(std::max(vertex_count_, unfolding_.rows())),
      constrained_(constrained_regions(scene)),
      pressurised_(pressurised_regions(scene)),
      pressure_gradient_(scene.film, rows_of(pressurised_, volumes_.size()),
                         static_cast<int>(pressurised_.size()), content_edges_, scene.edge_integral_order) {
  const film::Connectivity& complex = scene_.film.connectivity();
  input_.triangles = unfolding_.empty() ? complex.triangle_vertices : unfolding_.triangles();
  input_.regions = complex.triangle_regions;
  plan_ = SweepPlan(input_.triangles, lines_.size(), volumes_.size());
  input_.tension = scene_.film.columns(ElementKind::facet).reals("tension");
  input_.has_regions = labelled(input_.regions);
  if (input_.has_regions) rims_ = open_rims(scene.film);
  for (const film::Region region : pressurised_) pressures_.push_back(*scene.body(region).fixed_pressure);
  collect_tense_edges(scene);
  collect_quantities(scene);
  held_values_.resize(constrained_.size() + fixed_.size());
  constrained_gradient_ = VolumeGradient(scene.film, rows_of(constrained_, volumes_.size()),
                                         static_cast<int>(held_values_.size()), content_edges_,
                                         scene.edge_integral_order, fixed_rows());
  input_.corners = constrained_gradient_.corners();
  if (scene.film.periodic()) whole_cells_ = whole_cells(scene, unfolding_);
}

void FilmEnergy::collect_quantities(const scene::Scene& scene) {
  for (std::size_t row = 0; row < scene_.quantities.size(); ++row) {
    const scene::Quantity& quantity = scene_.quantities[row];
    if (quantity.role == scene::QuantityRole::info_only || quantity.modulus == 0) continue;
    const bool energy = quantity.role == scene::QuantityRole::energy;
    (energy ? quantities_ : fixed_sums_).emplace_back(scene_, quantity, scene.film.positions(), unfolding_);
    if (!energy) fixed_.push_back(row);
  }
  if (!quantities_.empty() || !fixed_.empty()) quantity_gradient_.resize(lines_.size());
}

std::vector<FixedRow> FilmEnergy::fixed_rows() const {
  std::vector<FixedRow> rows;
  for (std::size_t i = 0; i < fixed_sums_.size(); ++i) {
    FixedRow row{static_cast<int>(constrained_.size() + i), fixed_sums_[i].support()};
    for (std::uint32_t& v : row.vertices) v = vertex_of(film::Vertex(v)).index;
    rows.push_back(std::move(row));
  }
  return rows;
}

double FilmEnergy::size_of_fixed(std::size_t i, std::span<const Vec3> positions) const {
  std::vector<Vec3> extended;
  return fixed_sums_[i].size(unfolding_.empty() ? positions : unfolding_.extend(positions, extended),
                             scene_.time);
}

std::vector<std::array<std::uint32_t, 2>> FilmEnergy::far_pairs() const {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto add = [&](std::uint32_t u, std::uint32_t v) {
    pairs.push_back({vertex_of(film::Vertex(u)).index, vertex_of(film::Vertex(v)).index});
  };
  for (const QuantitySum& sum : quantities_) sum.for_each_far_pair(add);
  for (const QuantitySum& sum : fixed_sums_) sum.for_each_far_pair(add);
  return pairs;
}

void FilmEnergy::add_quantity_hessians(std::span<const Vec3> rows, std::span<const double> multipliers,
                                       HessianSink& sink) const {
  for (const QuantitySum& quantity : quantities_) quantity.add_hessian(rows, scene_.time, 1, sink);
  for (std::size_t i = 0; i < fixed_sums_.size(); ++i)
    fixed_sums_[i].add_hessian(rows, scene_.time, -multipliers[constrained_.size() + i], sink);
}

double FilmEnergy::tense_length() const {
  double sum = 0;
  const std::span<const std::array<film::Vertex, 2>> edges =
      unfolding_.empty() ? std::span(scene_.film.connectivity().edge_vertices) : unfolding_.edges();
  for (const auto& [tail, head] : edges)
    sum += length(input_.positions[head.index] - input_.positions[tail.index]);
  return sum;
}

void FilmEnergy::measure_held() {
  for (std::size_t i = 0; i < constrained_.size(); ++i) held_values_[i] = volumes_[constrained_[i].index];
  for (std::size_t i = 0; i < fixed_sums_.size(); ++i)
    held_values_[constrained_.size() + i] = fixed_sums_[i].value(input_.positions, scene_.time);
}

// After the sweep, whose lines they are read from.
void FilmEnergy::update_held_gradients() {
  if (held_values_.empty()) return;
  constrained_gradient_.finish(input_, lines_, open_volume_, scene_.time);
  for (std::size_t i = 0; i < fixed_sums_.size(); ++i) {
    std::fill(quantity_gradient_.begin(), quantity_gradient_.end(), Vec3{});
    fixed_sums_[i].add_gradient(input_.positions, scene_.time, 1, quantity_gradient_);
    unfolding_.fold<Vec3>(quantity_gradient_);
    constrained_gradient_.set_fixed(static_cast<int>(constrained_.size() + i), quantity_gradient_);
  }
}

void FilmEnergy::set_time(double time) {
  scene_.time = time;
  constraints_.set_time(time);
}

void FilmEnergy::set_variables(std::span<const language::VariableId> ids, std::span<const double> values) {
  for (std::size_t i = 0; i < ids.size(); ++i) scene_.variables.set(ids[i], values[i]);
  scene::bind_formulas(scene_);
  constraints_.set_variables(scene_.variables);
}

void FilmEnergy::renew_constraints(std::span<const Vec3> positions, std::span<const Vec3> force) {
  constraints_.renew(positions, force);
  constrained_gradient_.restrict(constraints_);
}

void FilmEnergy::collect_tense_edges(const scene::Scene& scene) {
  const std::span<const double> tension = scene.film.columns(ElementKind::edge).reals("tension");
  for (std::uint32_t e = 0; e < tension.size(); ++e) {
    const auto& ends = unfolding_.empty() ? scene.film.ends(film::Edge(e)) : unfolding_.edges()[e];
    if (tension[e] != 0) tense_.push_back({ends[0], ends[1], tension[e]});
  }
}

// Volumes are measured from a point of the film, so that a scene far from the origin loses no digits.
void FilmEnergy::start(std::span<const Vec3> positions) {
  assert(positions.size() == vertex_count_);
  input_.positions = unfolding_.empty() ? positions : unfolding_.extend(positions, extended_);
  input_.plan = &plan_;
  input_.origin = positions.empty() ? Vec3{} : positions[0];
}

double FilmEnergy::other_terms() {
  const std::span<const Vec3> positions = input_.positions;
  if (!unfolding_.empty()) {
    unfolding_.add_volumes(positions, input_.origin, volumes_);
    for (std::size_t r = 0; r < volumes_.size(); ++r) volumes_[r] += whole_cells_[r];
  }
  add_rim_volumes(rims_, positions, input_.origin, open_volume_, volumes_);
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) volumes_[b + 1] += scene_.bodies[b].volume_offset;
  const int order = scene_.edge_integral_order;
  for (const FieldEdge& edge : content_edges_)
    volumes_[edge.region.index] += edge_integral(edge, positions, scene_.time, order);
  double energy = 0;
  for (const FieldEdge& edge : energy_edges_) energy += edge_integral(edge, positions, scene_.time, order);
  for (const GapEdge& gap : gaps_) {
    energy += scene_.gap_constant *
              gap_energy(gap, positions[gap.tail.index], positions[gap.head.index], scene_.time).value;
  }
  for (const BoundaryGapEdge& gap : boundary_gaps_) {
    energy += scene_.gap_constant *
              boundary_gap_energy(scene_, gap, positions[gap.tail.index], positions[gap.head.index]).value;
  }
  for (const QuantitySum& quantity : quantities_) energy += quantity.value(positions, scene_.time);
  for (std::size_t i = 0; i < pressurised_.size(); ++i)
    energy -= pressures_[i] * volumes_[pressurised_[i].index];
  for (const HeavyFacet& facet : heavy_) {
    const auto& v = input_.triangles[facet.triangle];
    energy +=
        facet.weight * height_integral(positions[v[0].index], positions[v[1].index], positions[v[2].index]);
  }
  for (const TenseEdge& edge : tense_) {
    energy += edge.tension * length(positions[edge.head.index] - positions[edge.tail.index]);
  }
  measure_held();
  return energy;
}

void FilmEnergy::add_other_gradients() {
  const std::span<const Vec3> positions = input_.positions;
  for (const FieldEdge& edge : energy_edges_) {
    const EdgeGradient g = edge_integral_gradient(edge, positions, scene_.time, scene_.edge_integral_order);
    lines_[edge.from.index].gradient += g.from;
    lines_[edge.to.index].gradient += g.to;
  }
  for (const GapEdge& gap : gaps_) {
    const EdgeGradient g = gap_energy(gap, positions[gap.tail.index], positions[gap.head.index], scene_.time);
    lines_[gap.tail.index].gradient += scene_.gap_constant * g.from;
    lines_[gap.head.index].gradient += scene_.gap_constant * g.to;
  }
  for (const BoundaryGapEdge& gap : boundary_gaps_) {
    const EdgeGradient g =
        boundary_gap_energy(scene_, gap, positions[gap.tail.index], positions[gap.head.index]);
    lines_[gap.tail.index].gradient += scene_.gap_constant * g.from;
    lines_[gap.head.index].gradient += scene_.gap_constant * g.to;
  }
  std::fill(quantity_gradient_.begin(), quantity_gradient_.end(), Vec3{});
  for (const QuantitySum& quantity : quantities_)
    quantity.add_gradient(positions, scene_.time, 1, quantity_gradient_);
  for (std::size_t v = 0; v < quantity_gradient_.size(); ++v) lines_[v].gradient += quantity_gradient_[v];
  for (const HeavyFacet& facet : heavy_) {
    const auto& v = input_.triangles[facet.triangle];
    const auto g =
        height_integral_gradient(positions[v[0].index], positions[v[1].index], positions[v[2].index]);
    for (std::size_t k = 0; k < 3; ++k) lines_[v[k].index].gradient += facet.weight * g[k];
  }
  for (const TenseEdge& edge : tense_) {
    const Vec3 way = positions[edge.head.index] - positions[edge.tail.index];
    const double size = length(way);
    if (!(size > 0)) continue;
    const Vec3 pull = (edge.tension / size) * way;
    // The two ends against each other: an eigenvalue of twice the tension over the length.
    const double stiffness = 2 * std::abs(edge.tension) / size;
    lines_[edge.tail.index].gradient -= pull;
    lines_[edge.head.index].gradient += pull;
    lines_[edge.tail.index].stiffness += stiffness;
    lines_[edge.head.index].stiffness += stiffness;
  }
  unfolding_.fold<VertexLine>(lines_);
  add_pressure_gradients();
}

void FilmEnergy::add_pressure_gradients() {
  if (pressurised_.empty()) return;
  pressure_gradient_.update(input_, lines_, open_volume_, scene_.time);
  pressure_gradient_.set_multipliers(pressures_);
  for (std::size_t v = 0; v < vertex_count_; ++v) lines_[v].gradient -= pressure_gradient_.pull(v);
}

double FilmEnergy::value(std::span<const Vec3> positions) {
  start(positions);
  const SweepSums sums = sweep_energy(input_, volumes_);
  area_ = scene_.strings.on ? tense_length() : sums.area;
  return sums.energy + other_terms();
}

bool FilmEnergy::is_plain() const {
  return unfolding_.empty() && constraints_.empty() && energy_edges_.empty() && gaps_.empty() &&
         boundary_gaps_.empty() && quantity_gradient_.empty() && heavy_.empty() && tense_.empty() &&
         pressurised_.empty();
}

double FilmEnergy::gradient(std::span<const Vec3> positions, RowWork* work) {
  assert(work == nullptr || is_plain());
  if (work != nullptr && !positions.empty()) work->before(plan_.size(), 0, 1);
  start(positions);
  input_.slots = constrained_gradient_.next_slots();
  const SweepSums sums = sweep_gradient(input_, volumes_, lines_, work);
  unfolding_.fold<VertexLine>(lines_);
  area_ = scene_.strings.on ? tense_length() : sums.area;
  const double energy = sums.energy + other_terms();
  update_held_gradients();
  add_other_gradients();
  if (!constraints_.empty()) renew_constraints(positions, {});
  return energy;
}

}  // namespace lamella::energy
