#include "session/terminal_show.h"

#include <algorithm>
#include <optional>

// readline's header needs FILE to be known.
#include <cstdio>

#include <readline/readline.h>
#include <unistd.h>

#include "picture/png.h"
#include "session/terminal_graphics.h"

namespace lamella::session {

namespace {

struct KnownTerminal {
  std::optional<TerminalLooks> looks;
};

const TerminalLooks& looks_of_terminal(Session& session) {
  constexpr std::chrono::milliseconds patience{400};
  std::optional<TerminalLooks>& looks = session.memory<KnownTerminal>().looks;
  if (!looks) {
    session.output().flush();
    std::string typed;
    looks = ask_terminal(STDIN_FILENO, STDOUT_FILENO, patience, typed);
    for (const char c : typed) ::rl_stuff_char(static_cast<unsigned char>(c));
  }
  return *looks;
}

// Lines that stay free below a picture.
constexpr int free_lines = 2;

TerminalPicture in_half_blocks(const scene::Scene& scene, picture::PictureOptions options,
                               const TerminalLooks& looks, const WindowSize& window) {
  // Few pixels: many looks at each, and lines that are still seen.
  constexpr int samples = 24;
  constexpr double usual_height = 450;
  const int lines = std::max(window.rows - free_lines, 4);
  options.width = window.columns;
  options.height = 2 * lines;
  options.samples = samples;
  picture::Style& style = options.style;
  const double wider = std::clamp(usual_height / options.height, 1.0, 3.0);
  for (picture::LineStyle* line : {&style.border, &style.rim, &style.crease, &style.wire})
    line->radius *= wider;
  return {half_blocks(picture::render(scene, options), looks.colours), lines};
}

TerminalPicture in_pixels(const scene::Scene& scene, picture::PictureOptions options,
                          const TerminalLooks& looks, const WindowSize& window, bool own_size) {
  constexpr int widest = 1600;
  if (!own_size) {
    options.width = std::min(window.columns * looks.cell_width, widest);
    options.height = std::min(std::max(window.rows - free_lines - 1, 4) * looks.cell_height, widest);
  }
  const auto cells = [](int pixels, int size) { return (pixels + size - 1) / size; };
  const int lines = cells(options.height, looks.cell_height);
  const picture::Image image = picture::render(scene, options);
  if (looks.way == PictureWay::sixel) return {picture::sixels(image) + "\n", lines};
  return {picture::kitty_picture(picture::encode_png(image), cells(options.width, looks.cell_width), lines) +
              "\n",
          lines};
}

}  // namespace

bool shows_in_terminal(Session& session) {
  return !session.output().redirected() && draws_pictures(STDOUT_FILENO);
}

TerminalPicture terminal_picture(Session& session, const scene::Scene& scene,
                                 const picture::PictureOptions& options, bool own_size) {
  const TerminalLooks& looks = looks_of_terminal(session);
  const WindowSize window = window_size(STDOUT_FILENO);
  if (looks.way == PictureWay::half_blocks) return in_half_blocks(scene, options, looks, window);
  return in_pixels(scene, options, looks, window, own_size);
}

}  // namespace lamella::session
