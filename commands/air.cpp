#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct AirOptions {
  std::optional<long> cells;
  std::optional<std::array<double, 3>> from;
  std::optional<std::array<double, 3>> to;
  std::optional<VertexFormulas> fan;
  std::optional<VertexFormulas> jet;
  std::optional<double> viscosity;
  std::optional<double> pressure;
  bool still = false;
  bool off = false;

  bool changes() const { return cells || from || to || fan || jet || viscosity || pressure || still; }
};

film::Vec3 vector_of(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

void tell_of(Session& session, const std::optional<scene::Air>& air) {
  if (!air) return session.print("air off\n");
  session.print("air cells {} from ({}, {}, {}) to ({}, {}, {}) viscosity {} pressure {}\n", air->cells,
                air->from.x, air->from.y, air->from.z, air->to.x, air->to.y, air->to.z, air->viscosity,
                air->pressure);
  if (air->fan) session.print("fan ({})\n", air->fan->text());
  if (air->jet) session.print("jet ({})\n", air->jet->text());
  double fastest = 0;
  if (air->velocity) {
    for (const film::Vec3& v : *air->velocity) fastest = std::max(fastest, length(v));
  }
  session.print("fastest {:.6g} at time {:.6g}\n", fastest, air->time);
}

void run(Session& session, const AirOptions& options) {
  scene::Scene& scene = session.scene();
  std::optional<scene::Air>& air = scene.forces.air;
  if (options.off && options.changes()) throw text::Error("air, or off?", "air jet (1, 0, 0), or air off");
  if (options.off) return air.reset();
  if (!options.changes()) return tell_of(session, air);
  scene::Air next = air.value_or(scene::Air{});
  if (!air) next.time = scene.time;
  const bool new_box = options.cells || options.from || options.to;
  if (options.cells) next.cells = static_cast<int>(*options.cells);
  if (options.from) next.from = vector_of(*options.from);
  if (options.to) next.to = vector_of(*options.to);
  if (options.fan) next.fan = options.fan->formula;
  if (options.jet) next.jet = options.jet->formula;
  if (options.viscosity) next.viscosity = *options.viscosity;
  if (options.pressure) next.pressure = *options.pressure;
  if (!(next.from.x < next.to.x && next.from.y < next.to.y && next.from.z < next.to.z))
    throw text::Error("the box of air is empty", "from is the corner of the lowest x, y and z");
  if (new_box || options.still) {
    next.velocity.reset();
    next.time = scene.time;
  }
  air = std::move(next);
}

}  // namespace

extern const Command air_command = make_command<AirOptions>(
    {.name = "air",
     .summary = "a box of flowing air that blows on the film as evolve moves it",
     .group = CommandGroup::motion},
    {option("cells", &AirOptions::cells, "along each axis; 32 unless given").at_least(4).at_most(256),
     option("from", &AirOptions::from, "lowest corner of the box; (-2, -2, -2) unless given"),
     option("to", &AirOptions::to, "highest corner; (2, 2, 2) unless given"),
     option("jet", &AirOptions::jet, "velocity given to the air wherever it is not zero, by formulas"),
     option("fan", &AirOptions::fan, "force on each mass of air, by formulas"),
     option("viscosity", &AirOptions::viscosity, "area per time; 0 unless given").at_least(0),
     option("pressure", &AirOptions::pressure,
            "force for each unit of area and speed through the film; 1 unless given")
         .at_least(0),
     flag("still", &AirOptions::still, "stops the air"), flag("off", &AirOptions::off, "no air")},
    run);

}  // namespace lamella::session::commands
