#include "fe_contact/solver/march.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {

MarchReport march(double start, double end, const StepLimits &limits,
                  const std::function<Attempt(double, double)> &attempt) {
  MarchReport report;
  double t = start, wanted = limits.first;
  const double rounding = 1e-12 * std::max(std::abs(start), std::abs(end));
  while (end - t > rounding) {
    double dt = std::clamp(wanted, limits.smallest, limits.largest);
    if (t + 1.001 * dt >= end)
      dt = end - t;
    else if (t + 2 * dt > end)
      dt = 0.5 * (end - t); // no sliver of a last step
    const Attempt result = attempt(t, dt);
    if (result.accepted) {
      t += dt;
      ++report.steps;
      wanted = result.suggested_step > 0 ? result.suggested_step : std::max(wanted, dt) * limits.growth;
      if (result.last) break;
      continue;
    }
    ++report.cuts;
    if (dt <= limits.smallest * 1.001) {
      report.reached = t;
      report.reason = result.reason;
      return report;
    }
    wanted = result.suggested_step > 0 ? std::min(result.suggested_step, 0.7 * dt) : 0.5 * dt;
  }
  report.finished = true;
  report.reached = end - t > rounding ? t : end;
  report.wanted = wanted;
  return report;
}

} // namespace rimpact::fe
