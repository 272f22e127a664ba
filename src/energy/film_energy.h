// The energy of a scene as a function of its vertices' positions:
//
//   sum over facets of tension * area  +  sum over edges of tension * length
//   + sum over bodies of density * G * (integral of z over the body)  -  sum over bodies of pressure * volume
//   + sum over edges on constraints of their energies' integrals and gaps  +  sum of named quantities
//
// where pressure * volume runs over bodies of prescribed pressure. Only what the scene has is summed.
#pragma once

#include <span>
#include <vector>

#include "energy/edge_integral.h"
#include "energy/gap.h"
#include "energy/gravity.h"
#include "energy/open_rim.h"
#include "energy/quantity_sums.h"
#include "energy/sweep.h"
#include "energy/volume_gradient.h"
#include "film/large_pages.h"
#include "film/unfolding.h"
#include "scene/scene.h"

namespace lamella::energy {

// Everything in here belongs to one state of connectivity, tensions, densities and pressures: make it anew
// when those change (`stale`); positions are arguments.
class FilmEnergy {
 public:
  // The film must be compact.
  explicit FilmEnergy(const scene::Scene& scene);

  // The energy at given positions; `volumes()` are refreshed too.
  double value(std::span<const Vec3> positions);
  // The energy and its gradient in `lines()`. `work` goes along with the sweep where the film is plain; its
  // parts lie below `work_parts`.
  double gradient(std::span<const Vec3> positions, RowWork* work = nullptr);
  // Whether the sweep alone gives all of the gradient, and nothing holds vertices.
  bool is_plain() const;
  std::size_t work_parts() const { return plan_.size() + 1; }
  // What comes after a sweep, for the lines as they are: in any film, whose images of vertices are rows, too.
  void work_after_sweep(RowWork& work) const { energy::work_after_sweep(plan_, work); }

  // Volume of region r at the last call, volconst included; [0] is meaningless.
  std::span<const double> volumes() const { return volumes_; }
  double area() const {
    return area_;
  }  // plain area at the last call; length where films are of one dimension
  std::span<VertexLine> lines() { return {lines_.data(), vertex_count_}; }
  std::span<const VertexLine> lines() const { return {lines_.data(), vertex_count_}; }
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t triangle_count() const { return input_.triangles.size(); }

  // Volume gradients of the bodies with a target (row i belongs to region constrained()[i]), at the positions
  // of the last `gradient`.
  VolumeGradient& volume_gradient() { return constrained_gradient_; }
  const VolumeGradient& volume_gradient() const { return constrained_gradient_; }
  std::span<const film::Region> constrained() const { return constrained_; }

  // The scene's quantities that are fixed or conserved (rows in its list); their gradients are the rows of
  // `volume_gradient` after those of the bodies.
  std::span<const std::size_t> fixed() const { return fixed_; }
  // What is held: the volumes of `constrained`, then the values of `fixed`, at the last call.
  std::span<const double> held_values() const { return held_values_; }
  // The sum of the absolute values of what a fixed quantity is made of: the measure of its rounding.
  double size_of_fixed(std::size_t i, std::span<const Vec3> positions) const;

  // The vertices that level sets and boundaries hold. `gradient` renews their directions (every one-sided
  // constraint that is touched counts as holding) and restricts the volume gradients; `lines()` stay the
  // plain gradient.
  VertexConstraints& constraints() { return constraints_; }
  const VertexConstraints& constraints() const { return constraints_; }
  // Renews the directions by the force on each vertex, and restricts the volume gradients anew.
  void renew_constraints(std::span<const Vec3> positions, std::span<const Vec3> force);
  // Time at which formulas are evaluated.
  void set_time(double time);
  // New values of variables that formulas read.
  void set_variables(std::span<const language::VariableId> ids, std::span<const double> values);

  // What the energy is made of besides the sweep, for whoever sums second derivatives.
  struct TenseEdge {
    film::Vertex tail;
    film::Vertex head;
    double tension = 0;
  };
  // In a periodic film the corners of its triangles are rows of the unfolding.
  const SweepInput& input() const { return input_; }
  const film::Unfolding& unfolding() const { return unfolding_; }  // empty where there are no periods
  film::Vertex vertex_of(film::Vertex row) const {
    return unfolding_.empty() ? row : unfolding_.vertex_of(row);
  }
  const std::array<film::Vertex, 3>& vertices(std::size_t triangle) const {
    return scene_.film.connectivity().triangle_vertices[triangle];
  }
  std::span<const HeavyFacet> heavy() const { return heavy_; }
  std::span<const TenseEdge> tense_edges() const { return tense_; }
  std::span<const RimEdge> rims() const { return rims_; }
  // The second derivatives of the named quantities, and of the fixed ones with minus their multipliers;
  // positions and sink go by rows of the unfolding, if any.
  void add_quantity_hessians(std::span<const Vec3> rows, std::span<const double> multipliers,
                             HessianSink& sink) const;
  // Pairs of vertices that quantities couple without an edge between them.
  std::vector<std::array<std::uint32_t, 2>> far_pairs() const;
  std::span<const FieldEdge> energy_edges() const { return energy_edges_; }
  std::span<const FieldEdge> content_edges() const { return content_edges_; }
  std::span<const GapEdge> gaps() const { return gaps_; }
  std::span<const BoundaryGapEdge> boundary_gaps() const { return boundary_gaps_; }
  const scene::Scene& scene() const { return scene_; }
  double gap_constant() const { return scene_.gap_constant; }
  double time() const { return scene_.time; }
  int edge_integral_order() const { return scene_.edge_integral_order; }
  OpenVolume open_volume() const { return open_volume_; }
  std::span<const film::Region> pressurised() const { return pressurised_; }
  std::span<const double> prescribed_pressures() const { return pressures_; }  // of `pressurised`

 private:
  void collect_tense_edges(const scene::Scene& scene);
  void unfold(const scene::Scene& scene);
  void start(std::span<const Vec3> positions);
  double other_terms();
  void add_other_gradients();
  void add_pressure_gradients();
  void update_held_gradients();
  void collect_quantities(const scene::Scene& scene);
  std::vector<FixedRow> fixed_rows() const;
  void measure_held();
  double tense_length() const;

  scene::Scene scene_;  // its film shares the arrays that input_ points into, its formulas are bound
  SweepPlan plan_;
  SweepInput input_;
  std::size_t vertex_count_ = 0;
  film::Unfolding unfolding_;
  std::vector<Vec3> extended_;  // positions with those of images
  std::vector<double>
      whole_cells_;  // of each region's volume in a periodic film: see energy/periodic_volume.h
  OpenVolume open_volume_ = OpenVolume::above_plane;
  VertexConstraints constraints_;
  std::vector<FieldEdge> energy_edges_;
  std::vector<FieldEdge> content_edges_;
  std::vector<GapEdge> gaps_;
  std::vector<BoundaryGapEdge> boundary_gaps_;
  std::vector<QuantitySum> quantities_;
  std::vector<std::size_t> fixed_;
  std::vector<QuantitySum> fixed_sums_;
  std::vector<double> held_values_;
  std::vector<Vec3> quantity_gradient_;
  std::vector<RimEdge> rims_;
  std::vector<HeavyFacet> heavy_;
  std::vector<TenseEdge> tense_;
  std::vector<double> volumes_;
  std::vector<VertexLine, film::LargePages<VertexLine>> lines_;
  std::vector<film::Region> constrained_;
  std::vector<film::Region> pressurised_;
  std::vector<double> pressures_;  // of pressurised_
  VolumeGradient constrained_gradient_;
  VolumeGradient pressure_gradient_;
  double area_ = 0;
};

}  // namespace lamella::energy
