#include "calibration/studies/liner.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// Cosine of the angle at a circle's centre from the line of centres to where the circles meet.
double cosine_at(double own, double other, double distance) {
  return std::clamp((distance * distance + own * own - other * other) / (2 * distance * own), -1.0, 1.0);
}

/// Between a chord and its circle, the chord at angle acos(cosine) from the middle.
double segment(double radius, double cosine) {
  const double angle = std::acos(cosine);
  return radius * radius * (angle - std::sin(angle) * cosine);
}

/// A liner that its stroke crushes fully has this much energy per force [m].
double energy_per_force(const LinerCase &wanted, double stroke) {
  const double ring = wanted.wall_radius - stroke / wanted.crush_share;
  return liner_area(ring, wanted.slider_radius, stroke) / liner_chord(ring, wanted.slider_radius, stroke);
}

void require_in_range(const LinerCase &wanted) {
  const auto refuse = [](const char *what, double value, const char *bound) {
    throw InputError(fmt::format("a liner's {} {:g} must be {}", what, value, bound));
  };
  if (!(wanted.energy > 0)) refuse("energy", wanted.energy, "> 0 J");
  if (!(wanted.most_force > 0)) refuse("force", wanted.most_force, "> 0 N");
  if (!(wanted.slider_radius > 0 && wanted.slider_radius < wanted.wall_radius))
    refuse("slider's radius", wanted.slider_radius, "> 0 and below the wall's");
  if (!(wanted.crush_share > 0 && wanted.crush_share <= 1)) refuse("crush share", wanted.crush_share, "> 0 and <= 1");
}

} // namespace

double liner_chord(double ring, double slider, double depth) {
  const double cosine = cosine_at(ring, slider, ring - slider + depth);
  return 2 * ring * std::sqrt(1 - cosine * cosine);
}

double liner_area(double ring, double slider, double depth) {
  const double distance = ring - slider + depth;
  // Outside the ring lies the disc's segment beyond the chord, less the ring's own.
  return segment(slider, -cosine_at(slider, ring, distance)) - segment(ring, cosine_at(ring, slider, distance));
}

double liner_deepest(double ring, double slider) {
  return std::sqrt(ring * ring - slider * slider) - (ring - slider);
}

Liner liner_for(const LinerCase &wanted) {
  require_in_range(wanted);
  const double travel = wanted.wall_radius - wanted.slider_radius, ratio = wanted.energy / wanted.most_force;
  const auto fits = [&](double stroke) {
    const double ring = wanted.wall_radius - stroke / wanted.crush_share;
    return ring > wanted.slider_radius && stroke <= liner_deepest(ring, wanted.slider_radius);
  };
  double low = 0, high = travel * wanted.crush_share;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) { // the deepest stroke there is room for
    const double middle = (low + high) / 2;
    (fits(middle) ? low : high) = middle;
  }
  const double deepest = low;
  if (!(deepest > 0) || energy_per_force(wanted, deepest) < ratio)
    throw InputError(
        fmt::format("no liner stops {:.4g} kJ at {:.4g} kN: it needs a stroke above {:.4g} mm, the most that "
                    "the travel of {:.4g} mm and the slider have room for",
                    wanted.energy / 1e3, wanted.most_force / 1e3, 1e3 * deepest, 1e3 * travel));
  low = 0, high = deepest;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (energy_per_force(wanted, middle) < ratio ? low : high) = middle;
  }
  const double ring = wanted.wall_radius - high / wanted.crush_share;
  return {
      .thickness = high / wanted.crush_share, .stroke = high, .chord = liner_chord(ring, wanted.slider_radius, high)};
}

} // namespace rimpact::calibration
