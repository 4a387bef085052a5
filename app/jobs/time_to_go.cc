#include "app/jobs/time_to_go.h"

#include "fe_contact/planning/plan.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {

std::vector<RunTime> expected_times(const std::vector<Job> &jobs) {
  std::vector<RunTime> times;
  for (const auto &job : jobs) times.push_back({.expected = planning::make_plan(job.scene).expected_seconds});
  return times;
}

double time_to_go(const std::vector<RunTime> &runs, std::size_t at_once) {
  double expected = 0, took = 0;
  for (const auto &run : runs)
    if (run.state == RunTime::State::finished) expected += run.expected, took += run.spent;
  const double factor = expected > 0 ? took / expected : 1;
  std::vector<double> slots(std::max<std::size_t>(1, at_once), 0.0);
  const auto add = [&](double seconds) { *std::min_element(slots.begin(), slots.end()) += seconds; };
  for (const auto &run : runs)
    if (run.state == RunTime::State::running)
      add(std::max(0.1 * factor * run.expected, factor * run.expected - run.spent));
  for (const auto &run : runs)
    if (run.state == RunTime::State::waiting) add(factor * run.expected);
  return *std::max_element(slots.begin(), slots.end());
}

std::string about(double seconds) {
  if (seconds < 95)
    return fmt::format("about {:.0f} s",
                       seconds < 10 ? std::max(1.0, std::round(seconds)) : 5 * std::round(seconds / 5));
  const long minutes = std::lround(seconds / 60);
  return minutes < 100 ? fmt::format("about {} min", minutes)
                       : fmt::format("about {} h {} min", minutes / 60, minutes % 60);
}

} // namespace rimpact::app
