#include "fe_contact/solver/newton.h"

#include <algorithm>
#include <cmath>

namespace rimpact::fe {

double forcing_term(const std::vector<double> &residuals, double last, double tolerance, double finest) {
  constexpr double largest = 1e-2, gamma = 0.9;
  // What falls below the tolerance anyhow need not be solved further (Kelley 1995).
  const double enough = std::min(largest, std::max(finest, 0.3 * tolerance / residuals.back()));
  // A solution taken up again, its multipliers changed, starts near: Dembo, Eisenstat and Steihaug's choice.
  if (residuals.size() < 2) return std::clamp(residuals.back(), enough, largest);
  const double ratio = residuals.back() / residuals[residuals.size() - 2];
  const double safeguard = gamma * last * last;
  const double term = std::max(gamma * ratio * ratio, safeguard > 0.1 ? safeguard : 0.0);
  return std::clamp(term, enough, largest);
}

NewtonReport newton(NewtonTarget &target, Eigen::VectorXd &u, const NewtonOptions &options) {
  NewtonReport report;
  if (!options.evaluated && !target.evaluate(u)) {
    report.reason = "a cell turned inside out before the first iteration";
    return report;
  }
  const auto relative = [&] { return target.residual().norm() / target.force_scale(); };
  double forcing = 0;
  bool worn = false; // a factor of an earlier solution, or of another step, may still serve
  report.residuals.push_back(relative());
  while (report.residuals.back() > options.tolerance || report.iterations == 0) {
    if (report.iterations >= options.max_iterations) {
      report.reason = "Newton did not converge in " + std::to_string(options.max_iterations) + " iterations";
      return report;
    }
    ++report.iterations;
    forcing = forcing_term(report.residuals, forcing, options.tolerance, options.finest_forcing);
    Eigen::VectorXd change;
    if (options.stale_factor && !worn) {
      change = target.solver().solve(-target.residual(), forcing, most_linear_iterations);
      worn = target.solver().last_iterations() > worn_after;
    }
    if (change.size() == 0) {
      change = target.solver().solve_anew(-target.residual(), forcing, most_linear_iterations);
      ++report.factorisations;
      worn = false;
    }
    if (change.size() == 0 || !change.allFinite()) {
      report.reason = "the tangent is singular: is every body held by supports or contact?";
      return report;
    }
    // Bounded backtracking: contact is not smooth, so the best step found is taken when none is better. The
    // first change carries the step's loading, its residual is no measure: any admissible one will do.
    const Eigen::VectorXd start = u;
    const double before = report.residuals.back();
    double best = -1, best_factor = 0, factor = 1;
    for (int trial = 0; trial <= options.max_backtracks; ++trial, factor /= 2) {
      u = start + factor * change;
      if (!target.evaluate(u)) continue;
      const double reached = relative();
      if (best_factor == 0 || reached < best) {
        best = reached;
        best_factor = factor;
      }
      if (report.iterations == 1 || reached < before) break;
    }
    if (best_factor == 0 || !std::isfinite(best)) {
      report.reason = "a cell turned inside out";
      return report;
    }
    if (u != start + best_factor * change) {
      u = start + best_factor * change;
      target.evaluate(u);
    }
    report.residuals.push_back(best);
  }
  report.converged = true;
  return report;
}

} // namespace rimpact::fe
