#include "scene/published_pair.h"
#include "laws/impact/kelvin_voigt.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

constexpr double worth_saying = 0.2; // of the peak force

bool flies_on_pair(const Scene &scene) {
  const auto &r = scene.reduced;
  return r.k_i > 0 && r.impact_law->of_mass && r.calibration.empty() && !scene.rigid_bodies() &&
         has_default_element(scene);
}

/// The solid's peak force over that of a pair.
double share_of_pair(const SolidImpact &solid, double k_i, double restitution, double mass) {
  return solid.peak_force / (laws::kelvin_voigt_peak(restitution) * solid.speed * std::sqrt(k_i * mass));
}

} // namespace

SolidImpact solid_impact(double speed) {
  const auto after = std::find_if(solid_impacts.begin(), solid_impacts.end(),
                                  [&](const SolidImpact &impact) { return impact.speed >= speed; });
  if (after == solid_impacts.begin()) return solid_impacts.front();
  if (after == solid_impacts.end()) return solid_impacts.back();
  const auto &a = after[-1], &b = after[0];
  const double s = (speed - a.speed) / (b.speed - a.speed);
  return {speed, a.peak_force + s * (b.peak_force - a.peak_force), a.restitution + s * (b.restitution - a.restitution)};
}

std::optional<double> fastest_of_pair(const Scene &scene, double mass) {
  if (!flies_on_pair(scene)) return std::nullopt;
  Scene carried = scene;
  carried.load.mass = mass;
  if (!published_pair_applies(carried)) return 0;
  double fastest = solid_impacts.front().speed;
  constexpr int n_speeds = 1000;
  for (int i = 0; i <= n_speeds; ++i) {
    const double speed = std::lerp(solid_impacts.front().speed, solid_impacts.back().speed, double(i) / n_speeds);
    const double share = share_of_pair(solid_impact(speed), scene.reduced.k_i, scene.reduced.restitution, mass);
    if (std::abs(share - 1) > worth_saying) break;
    fastest = speed;
  }
  return fastest;
}

std::string doubt_of_published_pair(const Scene &scene, double fastest) {
  const auto &r = scene.reduced;
  if (fastest < solid_impacts.front().speed || !flies_on_pair(scene) || !published_pair_applies(scene)) return {};
  const SolidImpact solid = solid_impact(fastest);
  const double share = share_of_pair(solid, r.k_i, r.restitution, scene.load.mass);
  if (std::abs(share - 1) <= worth_saying) return {};
  return fmt::format("the thesis's pair is one for all speeds: at {:.2g} m/s{} finite elements (rung rigid-dish) give "
                     "this rim {:.2f} of the pair's peak force and a rebound of {:.2f} of the approach speed for {:g}; "
                     "take a law of the rim (rimpact main, then --calibration DIR)",
                     solid.speed, fastest > solid.speed ? fmt::format(", short of the {:.2g} m/s here,", fastest) : "",
                     share, solid.restitution, r.restitution);
}

} // namespace rimpact::scene
