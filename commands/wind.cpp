#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct WindOptions {
  std::optional<VertexFormulas> formulas;
  std::optional<double> pressure;
  bool off = false;
};

void run(Session& session, const WindOptions& options) {
  scene::Forces& forces = session.scene().forces;
  if (options.off && options.formulas) throw text::Error("a wind, or off?", "wind (1, 0, 0) or wind off");
  if (options.off) forces.wind.reset();
  if (options.formulas) forces.wind = options.formulas->formula;
  if (options.pressure) forces.wind_pressure = *options.pressure;
  if (options.off || options.formulas || options.pressure) return;
  if (forces.wind) {
    session.print("wind ({}) pressure {}\n", forces.wind->text(), forces.wind_pressure);
  } else {
    session.print("wind off\n");
  }
}

}  // namespace

extern const Command wind_command = make_command<WindOptions>(
    {.name = "wind",
     .summary = "air that blows on the film as evolve moves it, by formulas",
     .group = CommandGroup::motion},
    {positional("formulas", &WindOptions::formulas, "velocity of the air, in x, y, z, total_time"),
     option("pressure", &WindOptions::pressure,
            "force for each unit of area and speed through the film; 1 unless given")
         .at_least(0),
     flag("off", &WindOptions::off, "still air")},
    run);

}  // namespace lamella::session::commands
