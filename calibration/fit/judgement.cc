#include "calibration/fit/judgement.h"
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace rimpact::calibration {

namespace {

constexpr double both_sides_of_95 = 0.975;
/// A parameter whose 95 % interval reaches this share of its value to either side is not identified.
constexpr double vague = 0.5;
/// Condition (relative changes) beyond which the valley is called flat.
constexpr double flat_condition = 1e4;

double half_of_95(double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom > 1 ? freedom : 1), both_sides_of_95);
}

/// What a parameter in trouble is told, and by which verdict; empty: it is determined.
struct Judgement {
  Verdict verdict = Verdict::determined;
  std::string reason, note;
};

Judgement judgement(const Problem &problem, int i, const Covariance &spread, const Estimate &e, double half) {
  const Parameter &p = problem.parameter(i);
  const double size = problem.size(i, e.value), wide = half * e.standard_error, stated = half * e.stated_error;
  const bool low =
      e.value - problem.to_reported(i, problem.lower()(i)) < problem.to_reported(i, problem.upper()(i)) - e.value;
  if (problem.all_grazing() && !p.seen_in_flight)
    return {Verdict::grazing, "every impact only grazes the rim: a slightly different flight would miss it", {}};
  if (e.at_bound)
    return {Verdict::bound,
            fmt::format("it ended at the {} value allowed, {:.3g}{}", low ? "smallest" : "largest", e.value,
                        unit_behind(p.unit)),
            {}};
  if (!(spread.condition < flat_condition))
    return {Verdict::flat, "other values of the parameters together follow the data as well", {}};
  if (!(stated <= vague * size))
    return spread.measured ? Judgement{Verdict::noise,
                                       fmt::format("the noise of the record leaves +-{:.0f} % of the value open",
                                                   100 * stated / size),
                                       {}}
                           : Judgement{Verdict::flat,
                                       fmt::format("the data leave +-{:.0f} % of the value open", 100 * stated / size),
                                       {}};
  if (wide <= vague * size) return {};
  const std::string says =
      fmt::format("the data alone leave +-{:.1f} % of it open, but the law does not follow them, so "
                  "the 95 % interval is +-{:.0f} %",
                  100 * stated / size, 100 * wide / size);
  if (wide > size) return {Verdict::model_misfit, says, {}}; // an interval that reaches zero tells nothing
  return {Verdict::model_misfit, {}, fmt::format("{} is determined: {}", p.name, says)};
}

Estimate estimate_of(const Problem &problem, int i, double x, const Covariance &spread, double half) {
  const Parameter &p = problem.parameter(i);
  const double sd = std::sqrt(spread.covariance(i, i)), value = problem.to_reported(i, x);
  Estimate estimate;
  estimate.value = value;
  estimate.standard_error = p.logarithmic ? value * sd : sd;
  estimate.stated_error = std::isfinite(sd) && sd > 0
                              ? estimate.standard_error * std::sqrt(spread.stated_covariance(i, i)) / sd
                              : estimate.standard_error;
  estimate.interval_low = problem.to_reported(i, std::max(x - half * sd, problem.lower()(i)));
  estimate.interval_high = problem.to_reported(i, std::min(x + half * sd, problem.upper()(i)));
  estimate.at_bound = !spread.free[i];
  return estimate;
}

} // namespace

void judge(const Problem &problem, const Eigen::VectorXd &x, const Covariance &spread, FitResult &result) {
  const int n = problem.n_parameters();
  result.condition = spread.condition;
  for (int i = 0; i < n; ++i) {
    const double half = half_of_95(spread.freedom(i));
    Estimate estimate = estimate_of(problem, i, x(i), spread, half);
    const Judgement said = judgement(problem, i, spread, estimate, half);
    estimate.verdict = said.verdict, estimate.reason = said.reason;
    if (!said.note.empty()) result.notes.push_back(said.note);
    estimate.identifiable = estimate.reason.empty();
    result.parameters[problem.parameter(i).name] = estimate;
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double scale = std::sqrt(spread.covariance(i, i) * spread.covariance(j, j));
      const double value = i == j ? 1.0 : std::isfinite(scale) && scale > 0 ? spread.covariance(i, j) / scale : 0.0;
      result.correlation[problem.parameter(i).name][problem.parameter(j).name] = value;
    }
}

} // namespace rimpact::calibration
