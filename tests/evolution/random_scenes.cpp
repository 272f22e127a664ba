// Scenes made at random, moved, kicked, pulled and burst: nothing may tangle, break or fail to end.
//
// LAMELLA_RANDOM_SCENES, ..._STEPS and ..._BUBBLES in the environment ask for more than the short form, with
// a line for each scene on the standard output.
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "evolution/hyperbolic.h"
#include "film/check.h"
#include "film/intersections.h"
#include "support/random_motion.h"

namespace lamella::evolution {
namespace {

using scene::Scene;
using solve::Ending;

constexpr long spell = 10;        // steps between two checks
constexpr long most_events = 20;  // that befall a scene: more would heat it without end

int asked(const char* name, int otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr ? otherwise : std::atoi(value);
}

struct Tale {
  std::map<std::string, int> events;
  std::string fault;  // empty if all went well
  long steps = 0;
  double worst_volume = 0;
  TopologyCounts counts;
};

std::string fault_of(const Scene& scene) {
  if (const auto found = film::check(scene.film); !found.empty()) return found[0];
  if (const auto found = film::check_regions(scene.film, 1); !found.empty()) return found[0];
  if (!film::self_intersections(scene.film, 1).empty()) return "passes through itself";
  return {};
}

Tale tell(std::uint32_t seed, int most_bubbles, long steps) {
  Tale tale;
  Scene scene = test::random_bubbles(seed, most_bubbles);
  test::Chance chance(seed + 1000);
  const int at_first = test::bodies_present(scene);
  scene::Monitor monitor;
  StepSize size;
  size.topology = true;
  TopologyMemory memory;
  std::string after = "the beginning";
  const OnEvents note = [&](Scene& now, std::span<const surgery::Event> events) {
    for (const surgery::Event& event : events) ++tale.events[std::string(name_of(event.kind))];
    if (tale.fault.empty()) tale.fault = fault_of(now);
    if (!tale.fault.empty() && !events.empty())
      tale.fault += " at an event: " + std::string(name_of(events[0].kind));
  };
  while (tale.steps < steps && tale.fault.empty() && scene.film.triangle_count() > 0) {
    const EvolveReport report = evolve(scene, spell, size, monitor, {}, note, &memory);
    tale.steps += spell;
    tale.worst_volume = std::max(tale.worst_volume, report.volume_error);
    tale.counts.looks += report.topology.looks;
    tale.counts.refused += report.topology.refused;
    if (report.ending != Ending::step_limit && report.ending != Ending::converged && tale.fault.empty())
      tale.fault = "ended: " + std::string(solve::describe(report.ending));
    if (tale.fault.empty()) tale.fault = fault_of(scene);
    if (!tale.fault.empty()) {
      tale.fault += ", after " + after + ", at step " + std::to_string(tale.steps);
      break;
    }
    if (tale.steps % std::max(spell, steps / most_events) != 0) continue;
    const long left = std::max(0L, steps - tale.steps);
    const int kept = static_cast<int>(at_first * left / steps);
    const std::string what = test::befall(scene, chance, kept);
    if (what == "none") continue;
    after = what;
    ++tale.events[what];
  }
  return tale;
}

TEST(RandomScenes, EndWellAndUntangled) {
  const int scenes = asked("LAMELLA_RANDOM_SCENES", 12);
  const int steps = asked("LAMELLA_RANDOM_STEPS", 60);
  const int bubbles = asked("LAMELLA_RANDOM_BUBBLES", 6);
  const int first = asked("LAMELLA_RANDOM_FIRST", 0);
  const bool aloud = std::getenv("LAMELLA_RANDOM_SCENES") != nullptr;
  std::map<std::string, int> sum;
  double worst_volume = 0;
  int failed = 0;
  for (int seed = first; seed < first + scenes; ++seed) {
    const Tale tale = tell(static_cast<std::uint32_t>(seed), bubbles, steps);
    for (const auto& [name, count] : tale.events) sum[name] += count;
    worst_volume = std::max(worst_volume, tale.worst_volume);
    failed += tale.fault.empty() ? 0 : 1;
    EXPECT_EQ(tale.fault, "") << "scene " << seed;
    if (aloud)
      std::printf("%d: %ld steps, volume %.1e, refused %ld %s\n", seed, tale.steps, tale.worst_volume,
                  tale.counts.refused, tale.fault.c_str());
    std::fflush(stdout);
  }
  EXPECT_LT(worst_volume, 1e-9);
  if (!aloud) return;
  for (const auto& [name, count] : sum) std::printf("%s: %d\n", name.c_str(), count);
  std::printf("scenes %d, failed %d, worst volume error %.2e\n", scenes, failed, worst_volume);
}

// Here flips and averaging that made the mesh fit once drew films through one another, again and again.
TEST(RandomScenes, AMeshMadeFitDoesNotTangle) {
  EXPECT_EQ(tell(42, 8, 10).fault, "");
}

}  // namespace
}  // namespace lamella::evolution
