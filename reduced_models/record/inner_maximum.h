/// Largest value of a smooth function inside an interval, by the golden section.
#pragma once
#include <algorithm>
#include <cmath>

namespace rimpact::reduced {

/// Largest value of f over [0, 1] inside the interval, from values at its ends and middle; no search when a
/// parabola through them has its top outside or does not beat `known`.
template <class Function> double inner_maximum(const Function &f, double f0, double fm, double f1, double known) {
  const double curvature = f0 - 2 * fm + f1, slope = f1 - f0;
  if (!(curvature < 0) || std::abs(slope) >= -2 * curvature) return std::max({f0, fm, f1});
  const double top = fm - slope * slope / (8 * curvature);
  if (top + 1e-3 * std::abs(top) <= known) return std::max({f0, fm, f1});
  double a = 0, b = 1;
  constexpr double golden = 0.6180339887498949;
  double l = b - golden * (b - a), r = a + golden * (b - a), fl = f(l), fr = f(r);
  while (b - a > 1e-5) {
    if (fl > fr)
      b = r, r = l, fr = fl, l = b - golden * (b - a), fl = f(l);
    else
      a = l, l = r, fl = fr, r = a + golden * (b - a), fr = f(r);
  }
  return std::max({f0, fm, f1, fl, fr});
}

} // namespace rimpact::reduced
