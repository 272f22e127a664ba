#include "session/refused_words.h"

#include <algorithm>
#include <string>

#include "text/suggest.h"

namespace lamella::session {

namespace {

struct Refused {
  std::string_view word;
  std::string_view reason;
};

constexpr std::string_view pops = "pop_tri_to_edge and pop_edge_to_tri swap neighbours";
constexpr std::string_view merges = "elements are not merged one by one; delete edges collapses short ones";
constexpr std::string_view linear = "facets are flat and edges straight here: refine in their place";
constexpr std::string_view torus = "a periodic film stays one; pictures show each of its bodies whole";
constexpr std::string_view printers = "show FILE.pdf or show FILE.svg draws lines, show FILE.png a picture";
constexpr std::string_view geomview = "there is no window to talk to: show FILE.png draws a picture";
constexpr std::string_view menus = "it asks questions; its single commands do the same";
constexpr std::string_view matrices = "matrices are arrays of numbers without a calculus of their own";
constexpr std::string_view joins = "addload puts a datafile's film beside the present one";
constexpr std::string_view orders = "rows are put in order without being told";

constexpr Refused refused_table[] = {
    {"pop_quad_to_quad", pops},
    {"vertex_merge", merges},
    {"edge_merge", merges},
    {"facet_merge", merges},
    {"facet_crosscut", "facets are cut by refine"},
    {"quadratic", linear},
    {"lagrange", linear},
    {"simplex_to_fe", linear},
    {"A", "list variables shows them, and NAME := VALUE sets them"},
    {"b", "set body[1] target 1.5 or set body[1] pressure 2 changes one; v shows them"},
    {"X", "list attributes shows them"},
    {"e", "energies are not kept from one refinement to the next"},
    {"F", "commands are not logged by a letter"},
    {"reverse_orientation", "facets and edges keep the orientation of the datafile"},
    {"history", "the prompt keeps its lines itself: see the arrow keys"},
    {"transform_depth", "transform_expr says how pictures repeat the scene"},
    {"loghistogram", "histogram(facet, log(area)) does the same"},
    {"z", "curvature is measured on curved facets only, and there are none"},
    {"y", torus},
    {"detorus", torus},
    {"wrap_vertex", torus},
    {"postscript", printers},
    {"P", printers},
    {"oogl", geomview},
    {"ooglfile", geomview},
    {"geomview", geomview},
    {"geompipe", geomview},
    {"hessian_menu", menus},
    {"longj", menus},
    {"matrix_multiply", matrices},
    {"matrix_inverse", matrices},
    {"matrix_determinant", matrices},
    {"permload", "load replaces the scene, and the commands after it go on"},
    {"replace_load", joins},
    {"loadsub", joins},
    {"reorder_storage", orders},
    {"body_metis", orders},
    {"metis", orders},
    {"kmetis", orders},
    {"ometis", orders},
    {"binary_printf", "output is text: printf"},
    {"f", "gas does not diffuse between bodies by itself: set body target"},
    {"p", "bodies have volumes or pressures, and are not filled with gas"},
    {"optimize", "g takes the optimum of its line search unless m fixes the scale"},
    {"opt", "g takes the optimum of its line search unless m fixes the scale"},
    {"burchard", "g and relax minimise here"},
    {"sobolev", "relax minimises by a metric of its own"},
    {"sobolev_seek", "relax minimises by a metric of its own"},
    {"dirichlet", "relax minimises by a metric of its own"},
    {"dirichlet_seek", "relax minimises by a metric of its own"},
    {"move", "steps do not leave a direction behind to go on in"},
    {"display_text", "show draws annotations: see the pages on pictures"},
    {"delete_text", "show draws annotations: see the pages on pictures"},
    {"breakpoint", "commands run to their end"},
    {"unset_breakpoints", "commands run to their end"},
    {"subcommand", "commands run to their end"},
    {"pause", "commands run to their end"},
    {"load_library", "compiled libraries are not taken in"},
};

}  // namespace

std::string_view refusal(std::string_view word) {
  const std::string key = word.size() == 1 ? std::string(word) : text::lower(word);
  const auto* const at = std::find_if(std::begin(refused_table), std::end(refused_table),
                                      [&](const Refused& refused) { return refused.word == key; });
  return at == std::end(refused_table) ? std::string_view{} : at->reason;
}

}  // namespace lamella::session
