#include "ironing.h"

#include <algorithm>
#include <fmt/format.h>

namespace rimpact::verification {

Ironing::Ironing(ContactSystem &system, int x_equation, int z_equation)
    : state(system.at_rest()), system_(system), x_equation_(x_equation), z_equation_(z_equation) {
  options_.newton.exact_from = 0; // the rate of consistent tangents is part of the case
  options_.max_augmentations = 2;
  options_.gap_tolerance = options_.slip_tolerance = 1e-6;
  options_.tolerance_between = 1e-2;
}

fe::MarchReport Ironing::move(const Vector3d &from, const Vector3d &to, int pieces) {
  const auto attempt = [&](double t, double dt) -> fe::Attempt {
    fe::StepTerms terms{Eigen::VectorXd::Zero(state.u.size())};
    const Vector3d at = from + (t + dt) * (to - from);
    terms.driven = {{x_equation_, at.x()}, {z_equation_, at.z()}};
    const Eigen::VectorXd before = state.u;
    // Sliding goes on as it did: the last change is the first guess.
    const auto step = static_step(system_, state, terms, options_,
                                  change_.size() ? Eigen::VectorXd(state.u + change_) : Eigen::VectorXd());
    iterations += step.iterations;
    if (!step.converged) {
      change_.resize(0);
      return {false, 0, step.reason};
    }
    change_ = state.u - before;
    most_a_step = std::max(most_a_step, step.iterations);
    most_a_solution = std::max(most_a_solution, step.iterations / (1 + step.augmentations));
    ++steps;
    residuals_ = step.residuals;
    vertical.push_back(-state.reports[0].force.z());
    along.push_back(state.reports[0].force.x());
    return {true, 0, {}};
  };
  const auto report = fe::march(0, 1, {1.0 / pieces, 0.05 / pieces, 1.0 / pieces}, attempt);
  cuts += report.cuts;
  return report;
}

void Ironing::turn() {
  change_.resize(0);
  vertical.clear(), along.clear();
}

std::string Ironing::last_residuals() const {
  std::string text;
  for (const double value : residuals_) text += fmt::format(" {:.1e}", value);
  return text;
}

} // namespace rimpact::verification
