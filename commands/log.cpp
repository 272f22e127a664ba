#include "session/motion_log.h"
#include "session/session.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

struct LogOptions {
  std::optional<File> file;
  long every = 1;
  bool events = false;
};

void log_events(Session& session, const LogOptions& options) {
  EventLog& log = session.memory<EventLog>();
  if (!options.file) {
    session.print("log events {}\n", log.active() ? log.path() : "off");
  } else if (options.file->path == "off") {
    log.end();
  } else {
    try {
      log.begin(options.file->path);
    } catch (const text::Error& error) {
      throw error.placed_at(options.file->place);
    }
  }
}

void run(Session& session, const LogOptions& options) {
  if (options.events) return log_events(session, options);
  MotionLog& log = session.memory<MotionLog>();
  if (!options.file) {
    if (log.active()) {
      session.print("log {} every {}\n", log.path(), log.every());
    } else {
      session.print("log off\n");
    }
  } else if (options.file->path == "off") {
    log.end();
  } else {
    try {
      log.begin(options.file->path, options.every);
    } catch (const text::Error& error) {
      throw error.placed_at(options.file->place);
    }
  }
}

}  // namespace

extern const Command log_command = make_command<LogOptions>(
    {.name = "log",
     .summary = "write energies and momenta of the moving film into a table",
     .group = CommandGroup::motion},
    {positional("file", &LogOptions::file, "a CSV file, begun anew; off ends the log"),
     option("every", &LogOptions::every, "steps from row to row").at_least(1),
     flag("events", &LogOptions::events, "of changes of topology, a row each")},
    run);

}  // namespace lamella::session::commands
