#include "calibration/data/force_clock.h"
#include "calibration/data/channel_lag.h"
#include "calibration/data/channels.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// The response with its force taken `lag` earlier.
Response shifted(const Response &as_read, double lag) {
  Response r;
  const auto &time = as_read.series("time");
  const auto inside = [&](double t) { return t + lag >= time.front() && t + lag <= time.back(); };
  for (const auto &[name, from] : as_read.all())
    for (std::size_t i = 0; i < time.size(); ++i)
      if (inside(time[i])) r.append(name, from[i]);
  std::vector<double> at;
  for (const double t : r.series("time")) at.push_back(t + lag);
  for (const char *name : {"impact_x", "impact_y"}) r.series(name) = on_clock(time, as_read.series(name), at);
  for (const char *axis : {"x", "y"}) r.series(std::string("force_") + axis) = r.series(std::string("impact_") + axis);
  return r;
}

/// Where the hardest push and the largest travel lie.
double rough_lag(const Response &r) {
  const auto largest = [&](const char *x, const char *y) {
    std::size_t top = 0;
    double most = 0;
    for (std::size_t i = 0; i < r.size(); ++i)
      if (const double size = std::hypot(r.series(x)[i], r.series(y)[i]); size > most) most = size, top = i;
    return r.series("time")[top];
  };
  return largest("impact_x", "impact_y") - largest("displacement_x", "displacement_y");
}

/// What the impacts of the response still show.
std::optional<ForceClock> left_over(const std::string &folder, const scene::Scene &scene, const Response &response,
                                    const WindowOptions &options) {
  StoredRun run = make_run(folder, scene, response, options);
  for (const char *name : {"impact_x", "impact_y"}) run.response.series(name) = response.series(name); // as read
  const MeasuredRecord record(run, options);
  double sum = 0, weights = 0;
  int n = 0;
  for (std::size_t i = 0; i < std::min(record.contacts().size(), run.impacts.size()); ++i) {
    const auto found = channel_lag(run, record, i, run.impacts[i].direction);
    if (run.impacts[i].grazing || !found || !(found->unsure > 0)) continue;
    const double error = found->unsure / noise_reach;
    sum += found->lag / (error * error), weights += 1 / (error * error), ++n;
  }
  if (n == 0) return {};
  return ForceClock{sum / weights, 1 / std::sqrt(weights), n};
}

} // namespace

std::string ForceClock::sentence() const {
  return fmt::format(
      "the force comes {:.3g} +- {:.2g} ms {} the motion that it causes, by the momentum of {} impact{}: "
      "this is taken off",
      1e3 * std::abs(lag), 1e3 * unsure, lag < 0 ? "before" : "after", n_impacts, n_impacts == 1 ? "" : "s");
}

ForceClock align_force(const std::string &folder, const scene::Scene &scene, Response &response,
                       const WindowOptions &options) {
  constexpr int most_rounds = 8;
  constexpr double alike = 0.1; // of the standard error
  const auto &time = response.series("time");
  const double step = (time.back() - time.front()) / static_cast<double>(response.size() - 1);
  double lag = rough_lag(response);
  std::optional<ForceClock> found;
  for (int round = 0; round < most_rounds; ++round) {
    found = left_over(folder, scene, shifted(response, lag), options);
    if (!found) break;
    lag += found->lag;
    if (std::abs(found->lag) <= alike * std::max(found->unsure, 0.01 * step)) break;
  }
  if (!found)
    throw DataError(fmt::format("{}: estimate_lag finds no impact with {} samples of flight before and after it, which "
                                "tell when its impulse came; state the lag (lag_ms)",
                                folder, shortest_flight));
  response = shifted(response, lag);
  return {lag, found->unsure, found->n_impacts};
}

} // namespace rimpact::calibration
