#include "scene/quantity.h"

#include <algorithm>

namespace lamella::scene {

namespace {

using film::ElementKind;

struct MethodRow {
  Method method;
  std::string_view name;
  ElementKind kind;
  bool oriented;
};

constexpr std::array<MethodRow, 20> rows = {{
    {Method::vertex_scalar_integral, "vertex_scalar_integral", ElementKind::vertex, false},
    {Method::edge_length, "edge_length", ElementKind::edge, false},
    {Method::edge_length, "edge_tension", ElementKind::edge, false},
    {Method::density_edge_length, "density_edge_length", ElementKind::edge, false},
    {Method::edge_scalar_integral, "edge_scalar_integral", ElementKind::edge, false},
    {Method::edge_vector_integral, "edge_vector_integral", ElementKind::edge, true},
    {Method::facet_area, "facet_area", ElementKind::facet, false},
    {Method::facet_area, "facet_tension", ElementKind::facet, false},
    {Method::density_facet_area, "density_facet_area", ElementKind::facet, false},
    {Method::facet_volume, "facet_volume", ElementKind::facet, true},
    {Method::facet_scalar_integral, "facet_scalar_integral", ElementKind::facet, false},
    {Method::facet_vector_integral, "facet_vector_integral", ElementKind::facet, true},
    {Method::facet_general_integral, "facet_general_integral", ElementKind::facet, false},
    {Method::gravity_method, "gravity_method", ElementKind::facet, true},
    {Method::mean_curvature_integral, "mean_curvature_integral", ElementKind::edge, false},
    {Method::gauss_curvature_integral, "gauss_curvature_integral", ElementKind::facet, false},
    {Method::star_gauss_curvature, "star_gauss_curvature", ElementKind::vertex, false},
    {Method::star_gauss_curvature, "total_gauss_curvature", ElementKind::vertex, false},
    {Method::sq_mean_curvature, "sq_mean_curvature", ElementKind::vertex, false},
    {Method::star_perp_sq_mean_curvature, "star_perp_sq_mean_curvature", ElementKind::vertex, false},
}};

const MethodRow& row_of(Method method) {
  return *std::find_if(rows.begin(), rows.end(), [&](const MethodRow& row) { return row.method == method; });
}

}  // namespace

ElementKind element_of(Method method) {
  return row_of(method).kind;
}

std::string_view name_of(Method method) {
  return row_of(method).name;
}

const Method* method_named(std::string_view name) {
  const auto at =
      std::find_if(rows.begin(), rows.end(), [&](const MethodRow& row) { return row.name == name; });
  return at == rows.end() ? nullptr : &at->method;
}

bool is_oriented(Method method) {
  return row_of(method).oriented;
}

std::string target_variable(std::string_view name) {
  return std::string(name) + ".target";
}

std::string membership_column(std::string_view name) {
  return "quantity " + std::string(name);
}

}  // namespace lamella::scene
