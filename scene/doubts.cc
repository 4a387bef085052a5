#include "scene/doubts.h"

#include <algorithm>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Largest acceleration of the ground along one axis [g], scale included.
double largest_acceleration(const Scene &scene) {
  const Excitation &e = scene.excitation;
  if (e.kind == ExcitationKind::ricker) return std::abs(e.scale * e.amplitude_g);
  double largest = 0;
  if (e.kind == ExcitationKind::record)
    for (const auto *component : {&e.x, &e.y, &e.z})
      for (const double a : component->values) largest = std::max(largest, std::abs(e.scale * a) / scene.load.gravity);
  return largest;
}

} // namespace

std::vector<std::string> doubts(const Scene &scene) {
  constexpr double odd_weight = 20;    // weight over mass times gravity, or its inverse
  constexpr double strongest = 5;      // no ground has been recorded near it [g]
  constexpr double fastest = 10;       // an impact's speed [m/s]
  std::vector<std::string> found;
  const double inertial = scene.load.mass * scene.load.gravity, ratio = scene.load.vertical / inertial;
  if (scene.load.vertical > 0 && (ratio > odd_weight || ratio < 1 / odd_weight))
    found.push_back(fmt::format("load.vertical_kN = {:g} is {:.2g} times load.mass_kg = {:g} times gravity ({:.3g} kN): are the "
                                "units right?",
                                scene.load.vertical / 1e3, ratio, scene.load.mass, inertial / 1e3));
  if (const double a = largest_acceleration(scene); a > strongest)
    found.push_back(fmt::format("the ground's acceleration reaches {:.3g} g, beyond any recorded: are its unit and scale right?", a));
  if (scene.excitation.kind == ExcitationKind::window && scene.excitation.impact_speed() > fastest)
    found.push_back(fmt::format("excitation.speed_m_per_s times scale is {:g}: no bearing meets its rim so fast",
                                scene.excitation.impact_speed()));
  return found;
}

} // namespace rimpact::scene
