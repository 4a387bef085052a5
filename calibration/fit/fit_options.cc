#include "calibration/fit/fit_options.h"
#include "io/files/require.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace rimpact::calibration {

namespace {

/// A parameter of another law would not move anything.
void require_read(const std::vector<std::string> &parameters, const std::string &law) {
  const auto &own = laws::impact_law(law);
  for (const auto &name : parameters) {
    const bool of_a_law = std::any_of(laws::impact_laws().begin(), laws::impact_laws().end(),
                                      [&](const auto *other) { return other->reads(name); });
    if (of_a_law && !own.reads(name))
      throw InputError(fmt::format("{} is not read by the law {}, whose parameters are {}", name, law,
                                   fmt::join(own.parameters, ", ")));
  }
}

} // namespace

void FitOptions::validate() const {
  if (parameters.empty()) throw InputError("no parameter to fit is named, or every one is held");
  validate_words();
}

void FitOptions::validate_words() const {
  if (std::set<std::string>(parameters.begin(), parameters.end()).size() != parameters.size())
    throw InputError(fmt::format("a parameter to fit is named twice: {}", fmt::join(parameters, ", ")));
  for (const auto &name : parameters) calibration::parameter(name);
  if (!law.empty()) require_read(parameters, law);
  const auto fitted = [&](const std::string &name) {
    calibration::parameter(name);
    if (!parameters.empty() && std::find(parameters.begin(), parameters.end(), name) == parameters.end())
      throw InputError(fmt::format("{} is not among the parameters to fit: {}", name, fmt::join(parameters, ", ")));
  };
  const Parameter &restitution = calibration::parameter("e");
  for (const auto &[name, b] : bounds) {
    fitted(name);
    const auto &p = calibration::parameter(name);
    if (!(b.lower < b.upper))
      throw InputError(fmt::format("bounds of {}: {:g} must be < {:g}", name, b.lower, b.upper));
    require_bound(p.lower < 0 || b.lower > 0 || (b.lower == 0 && !p.logarithmic), "lower bound of " + name, b.lower,
                  "> 0");
    if (&p == &restitution)
      require_bound(b.upper <= 1 && b.lower > 0, "bound of e", b.upper > 1 ? b.upper : b.lower, "in (0, 1]");
  }
  for (const auto &[name, value] : start) {
    fitted(name);
    require_bound(value > 0 || calibration::parameter(name).lower <= 0, "start of " + name, value, "> 0");
  }
  for (const auto &[name, value] : fixed) {
    const auto &p = calibration::parameter(name);
    if (std::find(parameters.begin(), parameters.end(), name) != parameters.end())
      throw InputError(fmt::format("{} is to be fitted and to be held at {:g}", name, value));
    require_bound(value >= p.lower && value <= p.upper, "fixed " + name, value,
                  fmt::format("in {:g}..{:g} {}", p.lower, p.upper, p.unit));
  }
  require_bound(n_starts >= (start.empty() ? 1 : 0), "n_starts", n_starts, ">= 1, or 0 beside a given start");
  require_bound(n_starts <= 1000, "n_starts", n_starts, "<= 1000");
  require_bound(robust_scale >= 0, "robust_scale", robust_scale, ">= 0");
  require_bound(difference_step >= 1e-6 && difference_step <= 0.1, "difference_step", difference_step, "in 1e-6..0.1");
  require_bound(tolerance > 0 && tolerance <= 0.01, "tolerance", tolerance, "in 0..0.01");
  require_bound(max_iterations >= 1, "max_iterations", max_iterations, ">= 1");
  require_bound(uncertainty.force > 0, "uncertainty of the force", uncertainty.force, "> 0");
  require_bound(uncertainty.displacement > 0, "uncertainty of the displacement", uncertainty.displacement, "> 0");
  require_bound(uncertainty.speed > 0, "uncertainty of the speed", uncertainty.speed, "> 0");
  require_bound(uncertainty.gain >= 0 && uncertainty.gain <= 1, "uncertainty of the gain", uncertainty.gain, "in 0..1");
  require_bound(uncertainty.time >= 0, "uncertainty of the time", uncertainty.time, ">= 0 s");
  for (const double w : {weights.force, weights.displacement, weights.rebound, weights.peak, weights.flight})
    require_bound(w >= 0, "weight", w, ">= 0");
}

} // namespace rimpact::calibration
