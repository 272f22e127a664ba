#include "energy/film_energy.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lamella::energy {

namespace {

using film::ElementKind;

bool labelled(const film::View& view) {
  return std::any_of(view.regions.begin(), view.regions.end(),
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

std::vector<film::Region> constrained_regions(const scene::Scene& scene) {
  if (!scene.keep_volumes) return {};
  return regions_where(scene, [](const scene::Body& body) { return body.fixed_volume(); });
}

std::vector<film::Region> pressurised_regions(const scene::Scene& scene) {
  return regions_where(scene, [](const scene::Body& body) { return body.fixed_pressure && !body.absent; });
}

bool same_properties(const scene::Body& a, const scene::Body& b) {
  return a.fixed_volume() == b.fixed_volume() && a.fixed_pressure == b.fixed_pressure &&
         a.density == b.density && a.volume_offset == b.volume_offset && a.absent == b.absent;
}

}  // namespace

FilmEnergy::FilmEnergy(const scene::Scene& scene)
    : film_(scene.film),
      vertex_count_(scene.film.vertex_rows()),
      tension_revision_(scene.film.columns(ElementKind::facet).revision("tension")),
      edge_tension_revision_(scene.film.columns(ElementKind::edge).revision("tension")),
      open_volume_(scene.symmetric_content ? OpenVolume::cone_from_origin : OpenVolume::above_plane),
      bodies_(scene.bodies),
      gravity_(scene.gravity),
      keep_volumes_(scene.keep_volumes),
      heavy_(heavy_facets(scene)),
      volumes_(scene.bodies.size() + 1),
      lines_(vertex_count_),
      constrained_(constrained_regions(scene)),
      pressurised_(pressurised_regions(scene)),
      constrained_gradient_(film_, rows_of(constrained_, volumes_.size()),
                            static_cast<int>(constrained_.size())),
      pressure_gradient_(film_, rows_of(pressurised_, volumes_.size()),
                         static_cast<int>(pressurised_.size())) {
  const film::View view = film_.view();
  input_.triangles = view.triangles;
  input_.regions = view.regions;
  input_.tension = film_.columns(ElementKind::facet).reals("tension");
  input_.has_regions = labelled(view);
  if (input_.has_regions) rims_ = open_rims(film_);
  film_.edit_position_rows() = {};  // positions are arguments; holding these would only cost memory
  collect_bodies(scene);
  collect_tense_edges(scene);
}

bool FilmEnergy::stale(const scene::Scene& scene) const {
  return scene.film.connectivity_revision() != film_.connectivity_revision() ||
         scene.film.columns(ElementKind::facet).revision("tension") != tension_revision_ ||
         scene.film.columns(ElementKind::edge).revision("tension") != edge_tension_revision_ ||
         scene.gravity.on != gravity_.on || scene.gravity.constant != gravity_.constant ||
         scene.keep_volumes != keep_volumes_ ||
         scene.symmetric_content != (open_volume_ == OpenVolume::cone_from_origin) ||
         !std::equal(scene.bodies.begin(), scene.bodies.end(), bodies_.begin(), bodies_.end(),
                     same_properties);
}

void FilmEnergy::collect_bodies(const scene::Scene& scene) {
  for (const film::Region region : pressurised_) pressures_.push_back(*scene.body(region).fixed_pressure);
}

void FilmEnergy::collect_tense_edges(const scene::Scene& scene) {
  const std::span<const double> tension = scene.film.columns(ElementKind::edge).reals("tension");
  for (std::uint32_t e = 0; e < tension.size(); ++e) {
    const auto& ends = scene.film.ends(film::Edge(e));
    if (tension[e] != 0) tense_.push_back({ends[0], ends[1], tension[e]});
  }
}

// Volumes are measured from a point of the film, so that a scene far from the origin loses no digits.
void FilmEnergy::start(std::span<const Vec3> positions) {
  assert(positions.size() == vertex_count_);
  input_.positions = positions;
  input_.origin = positions.empty() ? Vec3{} : positions[0];
}

double FilmEnergy::other_terms(std::span<const Vec3> positions) {
  add_rim_volumes(rims_, positions, input_.origin, open_volume_, volumes_);
  for (std::size_t b = 0; b < bodies_.size(); ++b) volumes_[b + 1] += bodies_[b].volume_offset;
  double energy = 0;
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
  return energy;
}

void FilmEnergy::add_other_gradients(std::span<const Vec3> positions) {
  for (const HeavyFacet& facet : heavy_) {
    const auto& v = input_.triangles[facet.triangle];
    const auto g =
        height_integral_gradient(positions[v[0].index], positions[v[1].index], positions[v[2].index]);
    for (std::size_t k = 0; k < 3; ++k) lines_[v[k].index].gradient += facet.weight * g[k];
  }
  for (const TenseEdge& edge : tense_) {
    const Vec3 pull = edge.tension * unit(positions[edge.head.index] - positions[edge.tail.index]);
    lines_[edge.tail.index].gradient -= pull;
    lines_[edge.head.index].gradient += pull;
  }
  if (!pressurised_.empty()) {
    pressure_gradient_.update(input_, lines_, open_volume_);
    pressure_gradient_.set_multipliers(pressures_);
    for (std::size_t v = 0; v < vertex_count_; ++v) lines_[v].gradient -= pressure_gradient_.pull(v);
  }
}

double FilmEnergy::value(std::span<const Vec3> positions) {
  start(positions);
  const SweepSums sums = sweep_energy(input_, volumes_);
  area_ = sums.area;
  return sums.energy + other_terms(positions);
}

double FilmEnergy::gradient(std::span<const Vec3> positions) {
  start(positions);
  const SweepSums sums = sweep_gradient(input_, volumes_, lines_);
  area_ = sums.area;
  const double energy = sums.energy + other_terms(positions);
  if (!constrained_.empty()) constrained_gradient_.update(input_, lines_, open_volume_);
  add_other_gradients(positions);
  return energy;
}

}  // namespace lamella::energy
