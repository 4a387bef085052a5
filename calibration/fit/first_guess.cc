#include "calibration/fit/first_guess.h"
#include "calibration/fit/path_fit.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {

namespace {

bool gentler(const ImpactWindow *a, const ImpactWindow *b) {
  return a->peak < b->peak;
}

/// k of F = v sqrt(k m), the peak of a rim that does not yield.
double elastic_stiffness(const ImpactWindow &w, double mass) {
  return std::pow(w.peak / w.impact.approach_speed, 2) / mass;
}

} // namespace

scene::Scene first_guess(scene::Scene scene, const std::vector<const ImpactWindow *> &windows,
                         const std::vector<const Parameter *> &free) {
  if (windows.empty()) return scene;
  scene::ReducedSettings &r = scene.reduced;
  const ImpactWindow &hardest = **std::max_element(windows.begin(), windows.end(), gentler),
                     &gentlest = **std::min_element(windows.begin(), windows.end(), gentler);
  const double e = std::clamp(hardest.impact.restitution(), 0.05, 0.95);
  r.restitution = e;
  r.k_i = elastic_stiffness(hardest, scene.load.mass) / std::pow(laws::kelvin_voigt_peak(e), 2);
  if (!r.impact_law->yields) return scene;
  r.k_i = elastic_stiffness(gentlest, scene.load.mass); // it yields least
  r.yield_force = 0.4 * hardest.peak;
  return fit_over_path(scene, hardest, free);
}

} // namespace rimpact::calibration
