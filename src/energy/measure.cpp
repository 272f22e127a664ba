#include "energy/measure.h"

#include <algorithm>

#include "energy/edge_integral.h"
#include "energy/film_energy.h"
#include "energy/gap.h"
#include "energy/gravity.h"
#include "energy/periodic_volume.h"
#include "energy/quantity_sums.h"
#include "scene/constraint_sets.h"

namespace lamella::energy {

using film::ElementKind;

namespace {

double total_length(const film::Film& film, std::span<const double> tension, double& tense) {
  double sum = 0;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    if (!film.alive(film::Edge(i))) continue;
    const double l = length(film.vector(film::Edge(i)));
    sum += l;
    if (!tension.empty()) tense += tension[i] * l;
  }
  return sum;
}

void add_formula_terms(const scene::Scene& scene, Measures& m) {
  scene::Scene bound = scene;
  scene::bind_formulas(bound);
  const auto at = [&](film::Vertex v) { return scene.film.position(v); };
  const std::span<const Vec3> positions = scene.film.positions();
  const int order = scene.edge_integral_order;
  for (const FieldEdge& edge : energy_edges(bound))
    m.energy += edge_integral(edge, positions, scene.time, order);
  for (const FieldEdge& edge : content_edges(bound))
    m.volumes[edge.region.index] += edge_integral(edge, positions, scene.time, order);
  for (const GapEdge& gap : gap_edges(bound))
    m.energy += scene.gap_constant * gap_energy(gap, at(gap.tail), at(gap.head), scene.time).value;
  for (const BoundaryGapEdge& gap : boundary_gap_edges(bound)) {
    m.energy += scene.gap_constant * boundary_gap_energy(bound, gap, at(gap.tail), at(gap.head)).value;
  }
  for (const scene::Quantity& quantity : bound.quantities) {
    if (quantity.role == scene::QuantityRole::energy && quantity.modulus != 0)
      m.energy += quantity_value_of_bound(bound, quantity);
  }
}

bool has_formulas(const scene::Scene& scene) {
  return !scene.level_sets.empty() || !scene.boundaries.empty() || !scene.quantities.empty() ||
         scene.strings.on;
}

// A number that changes when a column of the film may have.
std::uint64_t columns_revision(const film::Film& film) {
  std::uint64_t sum = 0;
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    film.columns(kind).for_each(
        [&](const film::Column& column) { sum = 31 * sum + film.columns(kind).revision(column.name); });
  }
  return sum;
}

// The moduli of quantities, by which alone they change while the film stays.
double sum_of_moduli(const scene::Scene& scene) {
  double sum = 0;
  for (const scene::Quantity& quantity : scene.quantities) sum = 3 * sum + quantity.modulus;
  return sum;
}

}  // namespace

// Only sums are wanted, so nothing is prepared as for a solver.
Measures measure(const scene::Scene& scene) {
  const film::Film& film = scene.film;
  Measures m;
  m.volumes.assign(scene.bodies.size() + 1, 0.0);
  const film::Connectivity& c = film.connectivity();
  SweepInput input;
  input.positions = film.positions();
  input.triangles = c.triangle_vertices;
  input.regions = c.triangle_regions;
  input.tension = film.columns(ElementKind::facet).reals("tension");
  input.has_regions = !scene.bodies.empty();
  if (!input.positions.empty()) input.origin = input.positions[0];
  film::Unfolding unfolding;
  std::vector<Vec3> extended;
  if (film.periodic()) {
    unfolding = film::Unfolding(film);
    input.positions = unfolding.extend(input.positions, extended);
    input.triangles = unfolding.triangles();
  }
  const SweepSums sums = sweep_energy(input, m.volumes);
  m.area = sums.area;
  m.energy = sums.energy;
  m.length = total_length(film, film.columns(ElementKind::edge).reals("tension"), m.energy);
  if (scene.strings.on) m.area = m.length;
  if (film.periodic() && !scene.bodies.empty()) {
    unfolding.add_volumes(extended, input.origin, m.volumes);
    const std::vector<double> cells = whole_cells(scene, m.volumes);
    for (std::size_t r = 0; r < cells.size(); ++r) m.volumes[r] += cells[r];
  }
  if (has_formulas(scene)) add_formula_terms(scene, m);
  if (scene.bodies.empty()) return m;

  const OpenVolume convention =
      scene.symmetric_content ? OpenVolume::cone_from_origin : OpenVolume::above_plane;
  add_rim_volumes(open_rims(film), input.positions, input.origin, convention, m.volumes);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const scene::Body& body = scene.bodies[b];
    m.volumes[b + 1] += body.volume_offset;
    if (body.fixed_pressure && !body.absent) m.energy -= *body.fixed_pressure * m.volumes[b + 1];
  }
  m.energy += gravity_energy(scene);
  return m;
}

MeasureCache::Key MeasureCache::key_of(const scene::Scene& scene) {
  const bool formulas = has_formulas(scene);
  return {scene.film.connectivity_revision(),
          scene.film.position_revision(),
          scene.film.columns(ElementKind::facet).revision("tension"),
          scene.film.columns(ElementKind::edge).revision("tension"),
          scene.symmetric_content,
          scene.gravity.on,
          scene.gravity.constant,
          formulas ? scene.variables.revision() : 0,
          formulas ? scene.time : 0,
          formulas ? columns_revision(scene.film) : 0,
          sum_of_moduli(scene)};
}

bool MeasureCache::holds(const scene::Scene& scene) const {
  const auto same = [](const BodyKey& key, const scene::Body& body) {
    return key == BodyKey{body.density, body.volume_offset, body.fixed_pressure, body.absent};
  };
  return measures_ && key_ == key_of(scene) &&
         std::equal(bodies_.begin(), bodies_.end(), scene.bodies.begin(), scene.bodies.end(), same);
}

const Measures& MeasureCache::of(const scene::Scene& scene) {
  if (!holds(scene)) {
    measures_ = measure(scene);
    key_ = key_of(scene);
    bodies_.clear();
    for (const scene::Body& body : scene.bodies) {
      bodies_.push_back({body.density, body.volume_offset, body.fixed_pressure, body.absent});
    }
  }
  return *measures_;
}

}  // namespace lamella::energy
