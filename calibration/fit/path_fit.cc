#include "calibration/fit/path_fit.h"
#include "calibration/fit/bounded_search.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace rimpact::calibration {

namespace {

struct Pressed {
  double d, deepest, force;
};

std::vector<Pressed> pressed_samples(const ImpactWindow &w) {
  std::vector<Pressed> samples;
  double deepest = 0;
  for (std::size_t i = 0; i < w.force.size(); ++i) {
    const double d = w.displacement[i] - w.capacity;
    if (d > 0) samples.push_back({d, deepest, w.force[i]});
    deepest = std::max(deepest, d);
  }
  return samples;
}

/// Residuals of the force in shares of its peak, over the free numbers as a search moves them.
class ForceOverPath {
public:
  ForceOverPath(const scene::Scene &scene, const std::vector<Pressed> &samples, double peak,
                const std::vector<const Parameter *> &free)
      : scene_(scene), samples_(samples), peak_(peak), free_(free) {}

  scene::Scene with(const double *x) const {
    scene::Scene s = scene_;
    for (std::size_t i = 0; i < free_.size(); ++i) free_[i]->set(s, free_[i]->to_reported(x[i]) * free_[i]->si);
    return s;
  }
  bool operator()(double const *const *x, double *r) const {
    try {
      const auto s = with(x[0]);
      const auto rim = laws::rim_element(*s.reduced.impact_law, s.reduced, s.load.mass);
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        const auto &at = samples_[i];
        const double force = rim.trial({.d = at.d, .rate = 0, .deepest = at.deepest});
        r[i] = (std::max(0.0, force) - at.force) / peak_;
      }
    } catch (const Error &) { // numbers that the law refuses
      return false;
    }
    return true;
  }

private:
  const scene::Scene &scene_;
  const std::vector<Pressed> &samples_;
  double peak_;
  const std::vector<const Parameter *> &free_;
};

struct End {
  std::vector<double> x;
  double cost = std::numeric_limits<double>::infinity();
};

End descend(const ForceOverPath &law, int n_samples, const std::vector<const Parameter *> &free,
            const scene::Scene &from) {
  const auto n = static_cast<int>(free.size());
  End end;
  for (const Parameter *p : free) end.x.push_back(p->to_variable(std::clamp(p->get(from) / p->si, p->lower, p->upper)));
  auto *cost = new ceres::DynamicNumericDiffCostFunction<ForceOverPath>(new ForceOverPath(law));
  cost->AddParameterBlock(n), cost->SetNumResiduals(n_samples);
  ceres::Problem problem;
  problem.AddResidualBlock(cost, nullptr, end.x.data());
  keep_within(
      problem, end.x.data(), [&](int i) { return free[i]->to_variable(free[i]->lower); },
      [&](int i) { return free[i]->to_variable(free[i]->upper); });
  constexpr int max_iterations = 100;
  ceres::Solver::Summary summary;
  ceres::Solve(silent_solver(max_iterations), &problem, &summary);
  if (summary.IsSolutionUsable()) end.cost = summary.final_cost;
  return end;
}

} // namespace

scene::Scene fit_over_path(scene::Scene scene, const ImpactWindow &window, const std::vector<const Parameter *> &free) {
  const auto samples = pressed_samples(window);
  if (!scene.reduced.impact_law->yields || free.empty() || samples.size() < free.size()) return scene;
  double deepest = 0;
  for (const auto &at : samples) deepest = std::max(deepest, at.d);
  const ForceOverPath law(scene, samples, window.peak, free);
  End best;
  for (const double stiffer : {1.5, 5.0})        // than the straight line to the deepest point
    for (const double share : {0.3, 0.6, 0.9}) { // of the peak, at which it yields
      scene::Scene from = scene;
      from.reduced.k_i = stiffer * window.peak / deepest, from.reduced.yield_force = share * window.peak;
      End end = descend(law, static_cast<int>(samples.size()), free, from);
      if (end.cost < best.cost) best = std::move(end);
    }
  return std::isfinite(best.cost) ? law.with(best.x.data()) : scene;
}

} // namespace rimpact::calibration
