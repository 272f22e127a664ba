#include <algorithm>
#include <chrono>

#include "session/picture_words.h"
#include "session/session.h"
#include "session/terminal_show.h"

namespace lamella::session::commands {

namespace {

struct WatchWords : PictureWords {
  std::string state = "on";
};

// Draws the scene over its last picture, and not so often that it would slow down what is watched.
class Watcher {
 public:
  Watcher(Session& session, picture::PictureOptions options)
      : session_(session), options_(std::move(options)) {}

  void look(const scene::Scene& scene, bool settled) {
    const Clock::time_point begin = Clock::now();
    if (scene.empty() || (!settled && begin < next_)) return;
    try {
      draw(scene);
    } catch (const text::Error&) {
      return;  // a scene that cannot be drawn now may be drawn later
    }
    const Clock::time_point end = Clock::now();
    next_ = end + std::max<Clock::duration>(shortest, 3 * (end - begin));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds shortest{80};

  void draw(const scene::Scene& scene) {
    const TerminalPicture picture = terminal_picture(session_, scene, options_, false);
    const bool in_place = session_.output().position() == position_;
    session_.write(in_place ? fmt::format("\x1b[{}A{}", lines_, picture.text) : picture.text);
    session_.output().flush();
    position_ = session_.output().position();
    lines_ = picture.lines;
  }

  Session& session_;
  picture::PictureOptions options_;
  Clock::time_point next_;
  long position_ = -1;
  int lines_ = 0;
};

void refuse_what_lasts_not(const WatchWords& words) {
  if (words.color || words.thickness)
    throw text::Error("watch shows films in their own colours", "for a formula: show color=... at the end");
}

void run(Session& session, const WatchWords& words) {
  if (words.state == "off") {
    session.follow_steps({});
    return;
  }
  refuse_what_lasts_not(words);
  if (!shows_in_terminal(session)) {
    session.tell("there is no terminal to watch the film in\n");
    return;
  }
  picture::PictureOptions options = picture_options(session, words);
  options.content.facets.clear();
  const auto watcher = std::make_shared<Watcher>(session, std::move(options));
  session.follow_steps([watcher](const scene::Scene& scene, bool settled) { watcher->look(scene, settled); });
  if (!session.scene().empty()) watcher->look(session.scene(), true);
}

std::vector<ArgumentOf<WatchWords>> arguments() {
  std::vector<ArgumentOf<WatchWords>> table = {
      positional("state", &WatchWords::state, "whether to watch; on unless given").one_of({"on", "off"})};
  for (ArgumentOf<WatchWords>& word : picture_arguments<WatchWords>()) table.push_back(std::move(word));
  return table;
}

}  // namespace

extern const Command watch_command =
    make_command<WatchWords>({.name = "watch",
                              .summary = "draw the film in the terminal while it changes",
                              .group = CommandGroup::output},
                             arguments(), run);

}  // namespace lamella::session::commands
