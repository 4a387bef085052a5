#include "scene/published_pair.h"
#include "impact_laws/kelvin_voigt.h"
#include "scene/doubts.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {

SolidImpact solid_impact(double speed) {
  const auto after = std::find_if(solid_impacts.begin(), solid_impacts.end(),
                                  [&](const SolidImpact &impact) { return impact.speed >= speed; });
  if (after == solid_impacts.begin()) return solid_impacts.front();
  if (after == solid_impacts.end()) return solid_impacts.back();
  const auto &a = after[-1], &b = after[0];
  const double s = (speed - a.speed) / (b.speed - a.speed);
  return {speed, a.peak_force + s * (b.peak_force - a.peak_force), a.restitution + s * (b.restitution - a.restitution)};
}

std::string doubt_of_published_pair(const Scene &scene, double fastest) {
  const auto &r = scene.reduced;
  constexpr double worth_saying = 0.2; // of the peak force
  if (fastest < solid_impacts.front().speed || !r.impact_law->of_mass || !r.calibration.empty() ||
      !published_pair_applies(scene) || !has_default_element(scene))
    return {};
  const SolidImpact solid = solid_impact(fastest);
  const double pair = laws::kelvin_voigt_peak(r.restitution) * solid.speed * std::sqrt(r.k_i * scene.load.mass);
  const double share = solid.peak_force / pair;
  if (std::abs(share - 1) <= worth_saying) return {};
  return fmt::format("the thesis's pair is one for all speeds: at {:.2g} m/s{} finite elements (rung rigid-dish) give "
                     "this rim {:.2f} of the pair's peak force and a rebound of {:.2f} of the approach speed for {:g}; "
                     "take a law of the rim (rimpact main, then --calibration DIR)",
                     solid.speed, fastest > solid.speed ? fmt::format(", short of the {:.2g} m/s here,", fastest) : "",
                     share, solid.restitution, r.restitution);
}

} // namespace rimpact::scene
