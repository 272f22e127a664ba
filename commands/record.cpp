#include <cmath>

#include "exchange/recording.h"
#include "session/picture_words.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct RecordWords : PictureWords {
  File file;
  Commands commands;
  double fps = 30;
  std::optional<long> every;
  double speed = 1;
};

// Takes a frame at the beginning, and then at even times, between two steps where they fall there; or each
// `every` steps.
class Recorder {
 public:
  Recorder(Session& session, const RecordWords& words, exchange::Recording& recording)
      : session_(session), words_(words), recording_(recording), interval_(words.speed / words.fps) {
    const scene::Scene& scene = session.scene();
    begin_ = scene.time;
    remember(scene);
    add(scene);
  }

  // After the last step, which may end later than anyone was told of it.
  void end() {
    const scene::Scene& scene = session_.scene();
    if (!words_.every && scene.time > last_time_) add_until(scene);
  }

  void look() {
    // Positions change in place while a computation runs: values kept by revision are those of before.
    session_.scene().film.edit_positions();
    const scene::Scene& scene = session_.scene();
    if (words_.every) {
      if (++steps_ % *words_.every == 0) add(scene);
    } else if (scene.time > last_time_) {
      add_until(scene);
    }
    remember(scene);
  }

 private:
  void add_until(const scene::Scene& scene) {
    // Sums of steps miss round times by rounding.
    const double last = scene.time + 1e-9 * interval_;
    while (begin_ + static_cast<double>(moments_ + 1) * interval_ <= last) {
      ++moments_;
      add(at(begin_ + static_cast<double>(moments_) * interval_, scene));
    }
  }

  // Between the last step and this one on a straight line; where the mesh has changed, this one.
  scene::Scene at(double time, const scene::Scene& scene) const {
    scene::Scene result = scene;
    result.time = time;
    if (connectivity_ != scene.film.connectivity_revision()) return result;
    const double part = std::min((time - last_time_) / (scene.time - last_time_), 1.0);
    const std::span<film::Vec3> positions = result.film.edit_positions();
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] = (1 - part) * last_positions_[v] + part * positions[v];
    return result;
  }

  // Formulas of the words are evaluated while the commands run, among local values of their own: a place for
  // each loop that a formula may nest.
  picture::PictureOptions options_now() {
    constexpr std::uint32_t places = 1024;
    const language::Evaluation::Frame frame(session_.evaluation(), places);
    return picture_options(session_, words_);
  }

  void add(const scene::Scene& scene) {
    picture::PictureOptions options = options_now();
    if (!framing_) framing_ = picture::framing_of(scene, options);
    options.framing = framing_;
    if (options.content.field) {
      if (!ends_) ends_ = {options.content.field->low, options.content.field->high};
      std::tie(options.content.field->low, options.content.field->high) = *ends_;
    }
    recording_.add(scene, options);
  }

  void remember(const scene::Scene& scene) {
    last_time_ = scene.time;
    connectivity_ = scene.film.connectivity_revision();
    const std::span<const film::Vec3> now = scene.film.positions();
    last_positions_.assign(now.begin(), now.end());
  }

  Session& session_;
  const RecordWords& words_;
  exchange::Recording& recording_;
  double interval_;
  double begin_ = 0;
  long moments_ = 0;
  long steps_ = 0;
  double last_time_ = 0;
  std::uint64_t connectivity_ = 0;
  std::vector<film::Vec3> last_positions_;
  std::optional<picture::Framing> framing_;
  std::optional<std::pair<double, double>> ends_;  // of the colours
};

// Who followed before goes on with it, too.
class Following {
 public:
  Following(Session& session, Recorder& recorder) : session_(session) {
    before_ = session.follow_steps({});
    session.follow_steps([this, &recorder](const scene::Scene& scene, bool settled) {
      if (before_) before_(scene, settled);
      recorder.look();
    });
  }
  Following(const Following&) = delete;
  Following& operator=(const Following&) = delete;
  ~Following() { session_.follow_steps(std::move(before_)); }

 private:
  Session& session_;
  Session::Follower before_;
};

void run(Session& session, const RecordWords& words) {
  if (session.scene().empty()) throw text::Error("there is nothing to record", "load a datafile first");
  const auto placed = [&](const auto& function) {
    try {
      return function();
    } catch (const text::Error& error) {
      throw error.placed_at(words.file.place);
    }
  };
  std::string warning;
  const auto recording =
      placed([&] { return exchange::begin_recording(words.file.path, words.fps, warning); });
  if (!warning.empty()) session.warn(warning);
  {
    Recorder recorder(session, words, *recording);
    const Following following(session, recorder);
    session.run_within(*words.commands.block);
    recorder.end();
  }
  if (session.monitor().stop_requested()) return;
  if (recording->frames() == 1)
    session.warn(words.every ? "fewer steps were made than from one frame to the next"
                             : "no time has passed from which to take frames: every=1 takes each step");
  const std::string written = placed([&] { return recording->finish(); });
  session.tell("{} frames in {}\n", recording->frames(), written);
}

std::vector<ArgumentOf<RecordWords>> arguments() {
  std::vector<ArgumentOf<RecordWords>> table = {
      positional("file", &RecordWords::file, ".mp4, .gif, .webm, .png (numbered), .html or .pvd").required(),
      positional("commands", &RecordWords::commands, "what is recorded, in braces").required(),
      option("fps", &RecordWords::fps, "frames a second").above(0).at_most(1000),
      option("every", &RecordWords::every, "steps from frame to frame; even times unless given").at_least(1),
      option("speed", &RecordWords::speed, "units of time that pass in a second").above(0)};
  for (ArgumentOf<RecordWords>& word : picture_arguments<RecordWords>()) table.push_back(std::move(word));
  return table;
}

}  // namespace

extern const Command record_command = make_command<RecordWords>(
    {.name = "record", .summary = "make a film of what commands do", .group = CommandGroup::output},
    arguments(), run);

}  // namespace lamella::session::commands
