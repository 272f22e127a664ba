#include "datafile/keywords.h"

#include <algorithm>
#include <array>
#include <utility>

#include "text/suggest.h"

namespace lamella::datafile {

namespace {

struct SectionWord {
  std::string_view word;
  Section section;
};

constexpr std::array<SectionWord, 11> section_words = {{{"vertices", Section::vertices},
                                                        {"vertex", Section::vertices},
                                                        {"edges", Section::edges},
                                                        {"edge", Section::edges},
                                                        {"faces", Section::faces},
                                                        {"face", Section::faces},
                                                        {"facets", Section::faces},
                                                        {"facet", Section::faces},
                                                        {"bodies", Section::bodies},
                                                        {"body", Section::bodies},
                                                        {"read", Section::read}}};

struct RefusedWord {
  std::string_view word;
  std::string_view feature;
};

constexpr std::array<RefusedWord, 40> refused_words = {{
    {"rotation_order", "symmetry groups"},
    {"quadratic", "the quadratic model"},
    {"lagrange", "the Lagrange model"},
    {"lagrange_order", "the Lagrange model"},
    {"simplex_representation", "the simplex model"},
    {"pressure", "the ideal gas model"},
    {"diffusion", "diffusion of gas"},
    {"wulff", "crystalline surface energies"},
    {"metric", "Riemannian metrics"},
    {"conformal_metric", "Riemannian metrics"},
    {"klein_metric", "Riemannian metrics"},
    {"mobility", "mobilities"},
    {"mobility_tensor", "mobilities"},
    {"squared_curvature", "squared mean curvature"},
    {"square_curvature", "squared mean curvature"},
    {"squared_gaussian_curvature", "squared Gaussian curvature"},
    {"square_gaussian_curvature", "squared Gaussian curvature"},
    {"sqgauss", "squared Gaussian curvature"},
    {"mean_curvature_integral", "the integral of mean curvature"},
    {"normal_curvature", "normal curvature"},
    {"hessian_special_normal_vector", "directions of perturbation"},
    {"load_library", "compiled libraries"},
    {"everything_quantities", "named quantities"},
    {"convert_to_quantities", "named quantities"},
    {"effective_area", "ways of moving that are set in the top section"},
    {"approximate_curvature", "ways of moving that are set in the top section"},
    {"approx_curvature", "ways of moving that are set in the top section"},
    {"runge_kutta", "ways of moving that are set in the top section"},
    {"jiggle", "ways of moving that are set in the top section"},
    {"temperature", "ways of moving that are set in the top section"},
    {"homothety", "ways of moving that are set in the top section"},
    {"area_fixed", "fixed areas"},
    {"fixed_area", "fixed areas"},
    {"surface_energy", "surface energies by formula"},
    {"view_transforms_use_unique_point", "view transforms about a point"},
}};

constexpr std::array<std::string_view, 24> command_words = {
    "gravity",        "autorecalc",       "gv_binary",           "metric_conversion",
    "hessian_normal", "target_tolerance", "window_aspect_ratio", "background",
    "thickness",      "brightness",       "random_seed",         "scrollbuffersize",
    "transforms",     "transform_expr",   "show_trans",          "hessian_slant_cutoff",
    "scale_scale",    "ambient_pressure", "post_project",        "conj_grad",
    "autodisplay",    "quietgo",          "smooth_graph",        "linear_metric"};

template <class Words>
auto find_word(const Words& words, std::string_view word) {
  const std::string key = text::lower(word);
  return std::find_if(words.begin(), words.end(), [&](const auto& entry) { return entry.word == key; });
}

}  // namespace

std::optional<Section> section_named(std::string_view word) {
  const auto at = find_word(section_words, word);
  return at == section_words.end() ? std::nullopt : std::optional(at->section);
}

std::string_view name_of(Section section) {
  constexpr std::array<std::string_view, 5> names = {"vertices", "edges", "faces", "bodies", "read"};
  return names[static_cast<std::size_t>(section)];
}

std::optional<std::string_view> refused_feature(std::string_view word) {
  const auto at = find_word(refused_words, word);
  return at == refused_words.end() ? std::nullopt : std::optional(at->feature);
}

void collect_sections(std::vector<std::string>& into) {
  for (const SectionWord& entry : section_words) into.emplace_back(entry.word);
}

void collect_refused(std::vector<std::string>& into) {
  for (const RefusedWord& entry : refused_words) into.emplace_back(entry.word);
}

bool is_command_word(std::string_view word) {
  const std::string key = text::lower(word);
  return std::find(command_words.begin(), command_words.end(), key) != command_words.end();
}

}  // namespace lamella::datafile
