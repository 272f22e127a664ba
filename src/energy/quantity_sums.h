// Named quantities of a scene as functions of the vertices' positions.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "energy/angle_sums.h"
#include "energy/element_jet.h"
#include "energy/vertex_star.h"
#include "film/unfolding.h"
#include "scene/scene.h"

namespace lamella::energy {

// One quantity. Which elements it has, with their orientations and attributes, is found once; formulas point
// into the scene's quantities, which must live on and be bound.
class QuantitySum {
 public:
  // `positions` are those at which walls are taken for mirrors. In a periodic film everything below goes by
  // the rows of its unfolding; elsewhere that is empty.
  QuantitySum(const scene::Scene& scene, const scene::Quantity& quantity, std::span<const Vec3> positions,
              const film::Unfolding& unfolding);

  double value(std::span<const Vec3> positions, double time) const;
  // The sum of the absolute values of what the elements give.
  double size(std::span<const Vec3> positions, double time) const;
  // Adds `factor` times the gradient to a row for each vertex; returns the value.
  double add_gradient(std::span<const Vec3> positions, double time, double factor,
                      std::span<Vec3> gradient) const;
  void add_hessian(std::span<const Vec3> positions, double time, double factor, HessianSink& sink) const;

  // Calls function(row, row) for pairs that may have mixed second derivatives without an edge between them.
  template <class Function>
  void for_each_far_pair(Function&& function) const {
    angles_.for_each_far_pair(function);
    for (const Star& star : stars_) {
      const std::vector<std::uint32_t> rows = rows_of(star.star);
      for (std::size_t i = 1; i < rows.size(); ++i) {
        for (std::size_t k = i + 1; k < rows.size(); ++k) function(rows[i], rows[k]);
      }
    }
  }

  // The rows on which it depends, ascending.
  std::vector<std::uint32_t> support() const;

 private:
  struct Element {
    std::array<film::Vertex, 3> corners;
    double factor = 1;
    std::uint32_t first_attribute = 0;  // of a row in attributes_
  };
  struct Part {
    const scene::MethodInstance* instance = nullptr;
    std::size_t corners = 1;
    std::vector<Element> elements;
    std::vector<double> attributes;  // that the formulas read, element after element
  };
  struct Star {
    VertexStar star;
    scene::Method method = scene::Method::sq_mean_curvature;
    double factor = 1;
  };

  void collect(const scene::Scene& scene, const scene::Quantity& quantity,
               const scene::MethodInstance& instance, std::span<const Vec3> positions,
               const film::Unfolding& unfolding);
  void collect_angles(const scene::Scene& scene, scene::Method method, std::uint32_t row, double factor,
                      const film::Unfolding& unfolding);
  ElementJet jet(const Part& part, const Element& element, std::span<const Vec3> positions, double time,
                 Order order) const;

  std::vector<Part> parts_;
  std::vector<Star> stars_;
  AngleSums angles_;
  int edge_order_ = 3;
  int facet_order_ = 6;
  double constant_ = 0;
};

// The value of the scene's quantity in this row, as things stand.
double quantity_value(const scene::Scene& scene, std::size_t row);
// The same of a scene whose formulas are bound.
double quantity_value_of_bound(const scene::Scene& scene, const scene::Quantity& quantity);

}  // namespace lamella::energy
