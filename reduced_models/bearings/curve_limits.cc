#include "reduced_models/bearings/curve_limits.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::reduced {
namespace {

/// Largest distance along the wall from a touch to what it shares the rim with, and what that is worth.
struct Beside {
  double distance = 0, half_touch = 0; ///< [m]
};

/// Dents whose touches reach the present one: farther ones it does not know.
Beside farthest_dent(const DentedRim &rim, const Eigen::Vector2d &u, double d, const DentShape &shape) {
  Beside worst;
  const auto look = [&](double s, double deepest) {
    const double half = std::sqrt(2 * shape.flank() * std::max({d, deepest, 0.0}));
    if (std::abs(s) < 2 * half && std::abs(s) * worst.half_touch >= worst.distance * half) worst = {std::abs(s), half};
  };
  for (const Dent &dent : rim.dents()) look(along_wall(dent.direction, u, shape.wall), dent.deepest);
  for (const WallStroke &stroke : rim.strokes()) {
    const double s = along_wall(stroke.direction(), u, shape.wall);
    look(s, stroke.deepest());
    look(s - stroke.end_place(), stroke.deepest());
  }
  return worst;
}

} // namespace

std::optional<std::string> beyond_curve(const laws::RimCurve &curve, const PressedRim &press, const DentedRim &rim,
                                        const Eigen::Vector2d &u, const DentShape &shape) {
  constexpr double rounding = 1e-9;
  const double range = curve.range();
  if (press.d > range * (1 + rounding))
    return fmt::format(
        "the rim is pressed to {:.3f} mm, its curve ends at {:.3f} mm; push further (rimpact curve --speed)",
        1e3 * press.d, 1e3 * range);
  const double open = std::max(0.0, press.d), energy = press.mass / 2 * press.rate * press.rate,
               left = curve.work(range) - curve.work(open);
  if (press.rate > 0 && rim.deepest_at(u, shape) <= open && energy > left * (1 + rounding))
    return fmt::format("an approach at {:.3f} m/s exceeds the {:.3f} m/s that the curve can stop; push further "
                       "(rimpact curve --speed)",
                       press.rate, std::sqrt(2 * left / press.mass));
  if (press.airborne) return "the slider has lifted off the dish, along which the curve was pushed";
  if (const Beside beside = farthest_dent(rim, u, press.d, shape); beside.distance > curve_slide * beside.half_touch)
    return fmt::format("the touch lies {:.2f} mm along the wall from where the rim was pressed, the curve allows "
                       "{:.2f} mm: an oblique slide, or a hit beside a dent",
                       1e3 * beside.distance, 1e3 * curve_slide * beside.half_touch);
  return std::nullopt;
}

} // namespace rimpact::reduced
