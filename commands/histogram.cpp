#include <cmath>
#include <vector>

#include "session/session.h"

namespace lamella::session::commands {

namespace {

constexpr int bins = 20;

struct HistogramOptions {
  Sample sample;
};

void run(Session& session, const HistogramOptions& options) {
  std::vector<double> values;
  for_each_element(*options.sample.generator, session.evaluation(), [&](const language::Element&) {
    values.push_back(evaluate_number(*options.sample.value, session.evaluation()));
    return true;
  });
  if (values.empty()) throw text::Error("there are no such elements");
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double width = (*most - *least) / bins;
  std::vector<long> counts(bins, 0);
  for (const double value : values) {
    const double bin = width > 0 ? std::floor((value - *least) / width) : 0;
    ++counts[static_cast<std::size_t>(std::min<double>(bin, bins - 1))];
  }
  for (int i = 0; i < bins; ++i) {
    session.print("{:10.5g} - {:10.5g}     {}\n", *least + i * width, *least + (i + 1) * width,
                  counts[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

extern const Command histogram_command = make_command<HistogramOptions>(
    {.name = "histogram",
     .aliases = {"ohistogram"},
     .summary = "how often a value lies where, over elements",
     .group = CommandGroup::measure},
    {positional("sample", &HistogramOptions::sample, "elements and what to take of each").required()}, run);

}  // namespace lamella::session::commands
