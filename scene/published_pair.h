/// The thesis's constant pair, k_i = 450,000 kN/m and e = 0.65, beside what its own bearing does by finite elements.
#pragma once
#include "scene/scene.h"
#include <array>
#include <optional>

namespace rimpact::scene {

/// A straight impact of shfps-225 at an approach speed [m/s]: peak force [N], rebound over approach speed. Rung
/// rigid-dish, mesh 1: data/references, which a test holds against these.
struct SolidImpact {
  double speed, peak_force, restitution;
};
inline constexpr std::array solid_impacts{SolidImpact{0.07, 398.8e3, 0.843}, SolidImpact{0.10, 560.9e3, 0.713},
                                          SolidImpact{0.20, 902.0e3, 0.466}, SolidImpact{0.35, 1204e3, 0.306},
                                          SolidImpact{0.50, 1486e3, 0.241},  SolidImpact{0.70, 1846e3, 0.191},
                                          SolidImpact{1.00, 2260e3, 0.139},  SolidImpact{1.20, 2432e3, 0.102}};
/// Linear between the speeds; the last one beyond them.
SolidImpact solid_impact(double speed);

/// Fastest approach [m/s] up to which the published pair's peak force is within a fifth of the solid's; 0 where it
/// stands for another bearing or supported mass [kg], for which nothing is published. None: the scene does not fly on
/// it.
std::optional<double> fastest_of_pair(const Scene &scene, double mass);

/// Of a scene that flies on the published pair, on the bearing and mass it was published for: a sentence where the
/// solid's peak force is off by more than a fifth at its fastest approach [m/s]. Else empty.
std::string doubt_of_published_pair(const Scene &scene, double fastest);

} // namespace rimpact::scene
