#include "calibration/fit/fit.h"
#include "calibration/fit/judgement.h"
#include "calibration/fit/search.h"
#include "io/files/error.h"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace rimpact::calibration {

namespace {

/// Starts whose ends differ by less are the same minimum (in the fitted variable, relative to 1).
constexpr double same_minimum = 1e-3;
/// Noise of the force, in shares of its peak, below which what no sample's noise holds (interpolation, digits) is of
/// its size.
constexpr double audible = 1e-3;

/// The channel's gain, where its error was fitted.
std::optional<ChannelGain> gain_of(const Problem &problem, const Ending &end, const Covariance &spread) {
  if (!problem.fits_gain()) return {};
  double stated = 0; // the largest; records of one channel state the same
  for (const auto &block : problem.blocks()) stated = std::max(stated, block->gain_error());
  const int at = problem.n_parameters();
  return ChannelGain{1 + stated * end.x(at), stated * std::sqrt(spread.covariance(at, at)), stated};
}

/// Root mean square of the residuals, each group over its stated uncertainty.
double misfit(const Problem &problem, const Ending &end) {
  double weights = 0;
  for (const auto &block : problem.blocks())
    for (const Group &group : block->groups()) weights += group.weight * group.weight;
  return std::sqrt(2 * end.cost / weights);
}

/// Whether a law that yields may have been misled (others have one valley): it follows the data badly, or has run into
/// a bound.
bool doubtful(const Problem &problem, const Ending &end) {
  constexpr double bad = 3; // uncertainties
  return problem.blocks().front()->scene().reduced.impact_law->yields &&
         (misfit(problem, end) > bad || !held_at_bounds(problem, end.x).empty());
}

const Ending &best_of(const std::vector<Ending> &endings) {
  return *std::min_element(endings.begin(), endings.end(), [](const Ending &a, const Ending &b) {
    return a.usable != b.usable ? a.usable : a.cost < b.cost;
  });
}

FitResult result_of(const Problem &problem, const std::vector<Ending> &endings, const FitOptions &options) {
  const Ending *best = &best_of(endings);
  FitResult result;
  result.names = options.parameters;
  result.law = options.law;
  result.fixed = options.fixed;
  result.n_impacts = problem.n_impacts();
  for (const auto &block : problem.blocks()) result.n_residuals += block->size();
  result.n_starts = static_cast<int>(endings.size());
  result.notes = problem.notes();
  result.message = best->message;
  if (!best->usable) throw DataError("the fit failed from every start: " + best->message);
  result.cost = best->cost;
  result.converged = best->converged;
  for (const auto &e : endings)
    if (e.usable && (e.x - best->x).cwiseAbs().maxCoeff() < same_minimum) ++result.n_starts_agreeing;
  const Covariance spread = covariance_at(problem, best->x, best->nuisance, options.robust_scale);
  result.counting = options.counting;
  result.within_noise = spread.within_noise;
  judge(problem, best->x, spread, result);
  result.gain = gain_of(problem, *best, spread);
  result.n_evaluations = problem.n_evaluations();
  return result;
}

FitResult fit_once(const std::vector<const StoredRun *> &runs, const FitOptions &options) {
  const Problem problem(runs, options);
  std::vector<Ending> endings;
  double best = std::numeric_limits<double>::infinity();
  const auto search_from = [&](const std::vector<Eigen::VectorXd> &starts) {
    for (const auto &x : starts) {
      endings.push_back(search(problem, x, options, best));
      if (endings.back().usable) best = std::min(best, endings.back().cost);
    }
  };
  search_from(problem.starts());
  if (options.n_starts > 0 && doubtful(problem, best_of(endings)))
    search_from(problem.more_starts(2 * problem.n_parameters()));
  return result_of(problem, endings, options);
}

/// Whether samples may count one by one: all impacts are measured, with noise in both channels.
bool noisy_alone(const std::vector<const StoredRun *> &runs) {
  bool any = false;
  for (const StoredRun *run : runs)
    for (const auto &w : run->impacts) {
      any = true;
      if (!w.measurement || !(w.measurement->sigma_force > audible * w.peak) ||
          !(w.measurement->sigma_displacement > 0))
        return false;
    }
  return any;
}

/// The likelihood, from the fit by curves; none where the law is not within the noise by it.
std::optional<FitResult> by_sample(const std::vector<const StoredRun *> &runs, FitOptions options,
                                   const FitResult &by_curve) {
  for (const auto &name : options.parameters) options.start[name] = by_curve.parameters.at(name).value;
  options.counting = SampleWeighting::sample;
  options.n_starts = 0;
  options.robust_scale = 0; // a sum over hundreds of samples is no outlier
  try {
    FitResult result = fit_once(runs, options);
    if (!result.within_noise || !result.converged) return {};
    result.n_starts = by_curve.n_starts, result.n_starts_agreeing = by_curve.n_starts_agreeing;
    result.n_evaluations += by_curve.n_evaluations;
    return result;
  } catch (const Error &) { // nothing beyond the fit by curves is claimed
    return {};
  }
}

} // namespace

FitResult fit(const std::vector<const StoredRun *> &runs, const FitOptions &given) {
  FitOptions options = given;
  if (options.law.empty() && !runs.empty()) options.law = runs.front()->scene.reduced.impact_law->name;
  options.validate();
  if (options.counting == SampleWeighting::automatic) {
    options.counting = SampleWeighting::curve;
    const FitResult by_curve = fit_once(runs, options);
    if (!noisy_alone(runs)) return by_curve;
    return by_sample(runs, options, by_curve).value_or(by_curve);
  }
  return fit_once(runs, options);
}

std::vector<double> profile(const std::vector<const StoredRun *> &runs, const FitOptions &options,
                            const FitResult &best, const std::string &name, const std::vector<double> &values) {
  options.validate();
  FitOptions others = options;
  std::erase(others.parameters, name);
  if (others.parameters.size() == options.parameters.size())
    throw InputError(fmt::format("{} is not among the fitted parameters", name));
  if (others.parameters.empty()) throw InputError("a profile needs a second fitted parameter");
  others.bounds.erase(name);
  others.start.clear();
  others.counting = best.counting;
  if (best.counting == SampleWeighting::sample) others.robust_scale = 0;
  others.n_starts = 0;
  for (const auto &other : others.parameters) others.start[other] = best.parameters.at(other).value;
  std::vector<double> costs;
  for (const double value : values) {
    others.fixed[name] = value;
    costs.push_back(fit(runs, others).cost);
  }
  return costs;
}

scene::Scene with_settings(scene::Scene scene, const std::string &law, const std::map<std::string, double> &fixed) {
  if (!law.empty()) scene.reduced.impact_law = &laws::impact_law(law);
  for (const auto &[name, value] : fixed) {
    const auto &p = calibration::parameter(name);
    p.set(scene, value * p.si);
  }
  return scene;
}

scene::Scene with_fitted(const scene::Scene &scene, const FitResult &result) {
  scene::Scene fitted = with_settings(scene, result.law, result.fixed);
  for (const auto &[name, estimate] : result.parameters) {
    const auto &p = calibration::parameter(name);
    p.set(fitted, estimate.value * p.si);
  }
  return fitted;
}

} // namespace rimpact::calibration
