#include "calibration/fit/first_guess.h"
#include "impact_laws/catalogue.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <Eigen/QR>

namespace rimpact::calibration {

namespace {

using Between = std::pair<double, double>; ///< shares of the peak force

struct Samples {
  std::vector<double> depth, force;
};

/// Samples first .. last with such forces.
Samples samples_of(const ImpactWindow &w, std::size_t first, std::size_t last, const Between &shares) {
  Samples s;
  for (std::size_t i = first; i <= last; ++i)
    if (w.force[i] >= shares.first * w.peak && w.force[i] <= shares.second * w.peak)
      s.depth.push_back(w.displacement[i] - w.capacity), s.force.push_back(w.force[i]);
  return s;
}

/// Of force over depth.
std::optional<double> slope(const Samples &s) {
  const auto n = static_cast<Eigen::Index>(s.depth.size());
  if (n < 3) return {};
  Eigen::MatrixX2d A(n, 2);
  A.col(0).setOnes(), A.col(1) = Eigen::Map<const Eigen::VectorXd>(s.depth.data(), n);
  return A.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(s.force.data(), n))(1);
}

bool gentler(const ImpactWindow *a, const ImpactWindow *b) {
  return a->peak < b->peak;
}

/// k of F = v sqrt(k m), the peak of a rim that does not yield.
double elastic_stiffness(const ImpactWindow &w, double mass) {
  return std::pow(w.peak / w.impact.approach_speed, 2) / mass;
}

void read_yielding(const CurveReading &curve, scene::ReducedSettings &r) {
  r.k_i = std::max(r.k_i, curve.initial);
  r.hardening = std::clamp(curve.tangent / r.k_i, 0.005, 0.8);
  r.yield_force = std::clamp(curve.intercept(), 0.1 * curve.peak, 0.95 * curve.peak);
  const double beyond = std::pow(r.k_i * curve.deepest / r.yield_force, r.unloading_exponent);
  r.unloading_gain = std::clamp((curve.unloading / r.k_i - 1) / beyond, 0.01, 5.0);
}

} // namespace

std::optional<CurveReading> read_curve(const ImpactWindow &w) {
  if (w.force.empty()) return {};
  const auto at = [](const std::vector<double> &values) {
    return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  };
  const std::size_t turn = at(w.displacement), hardest = at(w.force), last = w.force.size() - 1;
  const auto initial = slope(samples_of(w, 0, hardest, {0.05, 0.4})),
             tangent = slope(samples_of(w, 0, hardest, {0.75, 2})),
             unloading = slope(samples_of(w, turn, last, {0.5, 0.95}));
  if (!initial || !tangent || !unloading || !(*initial > 0)) return {};
  return CurveReading{*initial, *tangent, *unloading, w.peak, w.displacement[turn] - w.capacity};
}

scene::Scene first_guess(scene::Scene scene, const std::vector<const ImpactWindow *> &windows) {
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
  if (const auto curve = read_curve(hardest)) read_yielding(*curve, r);
  return scene;
}

} // namespace rimpact::calibration
