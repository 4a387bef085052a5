#include "reduced_models/motion/rest.h"
#include <algorithm>

namespace rimpact::reduced {

double end_of_rest(const Dynamics &dynamics, const Mode &mode, const State &y, double t, double t_end, double scan) {
  const auto excess = [&](double at) { return dynamics.hold(mode, at, y).excess; };
  const auto root = [&](double low, double high) {
    for (int i = 0; i < 200 && high - low > 1e-14 + 2e-16 * high; ++i) {
      const double middle = (low + high) / 2;
      (excess(middle) > 0 ? high : low) = middle;
    }
    return high;
  };
  const auto &breaks = dynamics.ground.breakpoints();
  auto next_break = std::upper_bound(breaks.begin(), breaks.end(), t + 1e-12);
  double t0 = t, f0 = excess(t), t1 = t, f1 = f0;
  while (t1 < t_end) {
    double t2 = std::min(t1 + scan, t_end);
    // Between samples of a record the demand is convex: its maxima lie at the samples.
    if (next_break != breaks.end() && *next_break <= t2) t2 = *next_break++;
    const double f2 = excess(t2);
    if (f2 > 0) return root(t1, t2);
    if (breaks.empty() && f1 > f0 && f1 > f2) { // a maximum between: does it reach the limit?
      double a = t0, b = t2;
      for (int i = 0; i < 60; ++i) {
        const double l = b - 0.6180339887498949 * (b - a), r = a + 0.6180339887498949 * (b - a);
        (excess(l) > excess(r) ? b : a) = excess(l) > excess(r) ? r : l;
        if (f1 + 2 * std::max(f1 - f0, f1 - f2) < 0) break; // far below it
      }
      if (const double top = (a + b) / 2; excess(top) > 0) return root(t0, top);
    }
    t0 = t1, f0 = f1, t1 = t2, f1 = f2;
  }
  return t_end;
}

} // namespace rimpact::reduced
