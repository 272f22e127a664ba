#include "session/picture_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "picture/styles.h"
#include "picture/view_words.h"
#include "session/field_values.h"
#include "session/session.h"
#include "session/show_filter.h"
#include "text/suggest.h"
#include "text/whole_file.h"

namespace lamella::session {

namespace {

using picture::PictureOptions;

// `1600x1200`, or one number for a square.
std::pair<int, int> parsed_size(const Word& word) {
  const char* const begin = word.text.data();
  const char* const end = begin + word.text.size();
  std::array<int, 2> sides{};
  auto [at, error] = std::from_chars(begin, end, sides[0]);
  sides[1] = sides[0];
  if (error == std::errc() && at != end && (*at == 'x' || *at == 'X')) {
    std::tie(at, error) = [&] {
      const auto result = std::from_chars(at + 1, end, sides[1]);
      return std::pair(result.ptr, result.ec);
    }();
  }
  const bool out_of_range = error == std::errc::result_out_of_range;
  if (!out_of_range && (error != std::errc() || at != end)) {
    throw text::Error(word.place, fmt::format("\"{}\" is no size", word.text), "as in size=1600x1200");
  }
  for (const int side : sides) {
    if (!out_of_range && side >= 1 && side <= picture::largest_side) continue;
    throw text::Error(word.place, fmt::format("a picture cannot be {} pixels", word.text),
                      fmt::format("width and height may be 1 to {}", picture::largest_side));
  }
  return {sides[0], sides[1]};
}

template <class Function>
auto placed(const text::Place& place, Function&& function) {
  try {
    return function();
  } catch (const text::Error& error) {
    throw error.placed_at(place);
  }
}

void set_style(PictureOptions& options, const PictureWords& words) {
  if (words.style) {
    options.style =
        placed(words.style->place, [&] { return picture::style_named(text::lower(words.style->text)); });
  }
  picture::Style& style = options.style;
  for (picture::LineStyle* line : {&style.border, &style.rim, &style.crease, &style.wire, &style.mesh})
    line->radius *= words.line_width;
  if (words.opacity) {
    style.film.opacity = *words.opacity;
    style.film.grazing = std::max(style.film.grazing, *words.opacity);
  }
  if (words.iridescence) style.film.iridescence = *words.iridescence;
  if (words.drain) {
    style.film.thickness_top = (*words.drain)[0];
    style.film.thickness_bottom = (*words.drain)[1];
  }
  options.line_width = words.line_width;
  options.transparent = words.transparent;
  options.shadow = words.shadow;
  if (!words.background) return;
  const std::string name = text::lower(words.background->text);
  if (name == "none") {
    options.transparent = true;
    return;
  }
  const auto colour = picture::colour_named(name);
  if (!colour) {
    std::vector<std::string> names = picture::colour_names();
    names.emplace_back("none");
    const std::string near = text::did_you_mean(name, names);
    throw text::Error(words.background->place, fmt::format("\"{}\" is no colour", words.background->text),
                      near.empty() ? "colours have names, as white, or are written #rrggbb" : near);
  }
  style.background_top = style.background_bottom = *colour;
}

bool names_a_view(const std::string& name) {
  const std::vector<std::string> names = picture::view_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

picture::View chosen_view(Session& session, const PictureWords& words) {
  picture::View view = present_view(session, session.memory<ViewMemory>().view);
  if (words.view) {
    const std::string& name = words.view->path;
    const bool is_file = !names_a_view(text::lower(name)) && name.find_first_of("./") != std::string::npos;
    placed(words.view->place, [&] {
      if (is_file) {
        view = picture::read_view(text::read_whole_file(name));
      } else {
        view.rotation = picture::rotation_named(text::lower(name));
      }
    });
  }
  if (words.from) {
    const auto& [x, y, z] = *words.from;
    if (x == 0 && y == 0 && z == 0) throw text::Error("from (0, 0, 0) is no direction");
    view.rotation = picture::looking_from({x, y, z});
  }
  if (words.rotate) {
    const auto& [right, up, roll] = *words.rotate;
    view.rotation = picture::turned(view.rotation, right, up, roll);
  }
  if (words.zoom) view.zoom *= *words.zoom;
  if (words.pan) {
    view.right += (*words.pan)[0];
    view.up += (*words.pan)[1];
  }
  if (words.lens) view.field_of_view = *words.lens;
  return view;
}

std::vector<double> edges_to_facets(const film::Film& film, const std::vector<double>& of_edges) {
  std::vector<double> result(film.triangle_rows(), std::numeric_limits<double>::quiet_NaN());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(film::Triangle(t))) continue;
    result[t] = 0;
    for (const film::SignedEdge e : film.edges(film::Triangle(t))) result[t] += of_edges[e.edge().index] / 3;
  }
  return result;
}

std::vector<double> facets_to_vertices(const film::Film& film, const std::vector<double>& of_facets) {
  std::vector<double> sums(film.vertex_rows(), 0);
  std::vector<double> counts(film.vertex_rows(), 0);
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(film::Triangle(t))) continue;
    for (const film::Vertex v : film.corners(film::Triangle(t))) {
      sums[v.index] += of_facets[t];
      counts[v.index] += 1;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = counts[v] > 0 ? sums[v] / counts[v] : 0;
  return sums;
}

// The extremes of what is drawn, so that hidden facets leave the colours to the others.
std::pair<double, double> extremes(const picture::ColourField& field, const film::Film& film,
                                   const std::vector<std::uint8_t>& drawn) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const auto include = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(film::Triangle(t)) || (!drawn.empty() && drawn[t] == 0)) continue;
    if (field.of == film::ElementKind::facet) {
      include(field.values[t]);
    } else {
      for (const film::Vertex v : film.corners(film::Triangle(t))) include(field.values[v.index]);
    }
  }
  return low <= high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

picture::ColourField colour_field(Session& session, const PictureWords& words,
                                  const std::vector<std::uint8_t>& drawn) {
  const film::Film& film = session.scene().film;
  picture::ColourField field;
  field.values = values_of(session, *words.color);
  if (words.color->kind == language::ElementKind::edge) field.values = edges_to_facets(film, field.values);
  field.of = words.color->kind == language::ElementKind::vertex ? film::ElementKind::vertex
                                                                : film::ElementKind::facet;
  field.map = picture::colour_map_named(words.map);
  field.title = words.color->text;
  std::tie(field.low, field.high) = extremes(field, film, drawn);
  if (words.range) {
    field.low = (*words.range)[0];
    field.high = (*words.range)[1];
    if (!(field.low < field.high)) {
      throw text::Error(fmt::format("range ({}, {}) is empty", field.low, field.high),
                        "the lower number comes first");
    }
  }
  return field;
}

std::vector<double> thickness_of(Session& session, const Field& formula) {
  const film::Film& film = session.scene().film;
  std::vector<double> values = values_of(session, formula);
  if (formula.kind == language::ElementKind::edge) values = edges_to_facets(film, values);
  if (formula.kind != language::ElementKind::vertex) values = facets_to_vertices(film, values);
  for (const double value : values) {
    if (value < 0) throw text::Error(fmt::format("a film cannot be {:.6g} nm thick", value));
  }
  return values;
}

std::vector<std::uint8_t> drawn_facets(const Session& session, const Elements& elements) {
  if (elements.kind != language::ElementKind::facet) {
    throw text::Error(fmt::format("a picture is made of facets, not {}", language::plural_of(elements.kind)),
                      "as in: show facets where color == red");
  }
  if (elements.list.empty()) throw text::Error("no facet is like that: there is nothing to draw");
  std::vector<std::uint8_t> drawn(session.scene().film.triangle_rows(), 0);
  for (const language::Element& element : elements.list) drawn[element.row] = 1;
  return drawn;
}

}  // namespace

picture::View present_view(const Session& session, const std::optional<picture::View>& set) {
  return set ? *set : picture::view_of(session.scene());
}

PictureOptions picture_options(Session& session, const PictureWords& words) {
  PictureOptions options;
  if (words.size) std::tie(options.width, options.height) = parsed_size(*words.size);
  if (words.width) options.width = *words.width;
  if (words.height) options.height = *words.height;
  if (words.samples) options.samples = *words.samples;
  set_style(options, words);
  options.view = chosen_view(session, words);
  picture::Content& content = options.content;
  const std::optional<Elements> shown = words.elements ? words.elements : shown_facets(session);
  if (shown) content.facets = drawn_facets(session, *shown);
  if (words.color) {
    content.field = colour_field(session, words, content.facets);
    // What is measured matters more than what shines.
    options.style.film.tint_opacity = std::max(options.style.film.tint_opacity, 0.8);
    options.style.film.iridescence = 0;
  }
  if (words.thickness) content.thickness = thickness_of(session, *words.thickness);
  if (words.clip) {
    const auto& [a, b, c, d] = *words.clip;
    if (a == 0 && b == 0 && c == 0) throw text::Error("clip (0, 0, 0, ...) is no plane");
    content.clip = picture::ClippingPlane{{a, b, c}, d};
  }
  content.explode = words.explode;
  options.annotations = {words.legend || words.color.has_value(), words.axes, words.scale_bar, words.labels};
  return options;
}

}  // namespace lamella::session
