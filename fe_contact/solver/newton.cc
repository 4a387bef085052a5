#include "fe_contact/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

namespace {

/// Makes the change of u that of the bordered system; returns the multiplier's, nothing when it cannot be solved.
std::optional<double> add_border(const Border &border, LinearSolver &solver, double forcing, Eigen::VectorXd &change) {
  const Eigen::VectorXd response = solver.solve(border.push, forcing, most_linear_iterations);
  if (response.size() == 0) return {};
  const double multiplier_change = (-border.constraint - border.gradient.dot(change)) / border.gradient.dot(response);
  change += multiplier_change * response;
  return multiplier_change;
}

/// Going on as it did the next residual will do: its tangent need not be made.
bool is_last(const std::vector<double> &residuals, double tolerance) {
  return residuals.size() > 1 && residuals.back() * (residuals.back() / residuals[residuals.size() - 2]) < tolerance;
}

/// Contact points that come and go by turns: the residual creeps, and a shorter step costs less than the end of it.
bool stagnates(const std::vector<double> &residuals, int patience) {
  constexpr double least_fall = 0.6;
  const std::size_t n = residuals.size(), back = static_cast<std::size_t>(patience) + 1;
  return patience > 0 && n > back && residuals[n - 1] > least_fall * residuals[n - back];
}

bool evaluate(NewtonTarget &target, const Eigen::VectorXd &u, bool with_tangent) {
  target.has_tangent = false;
  if (!target.evaluate(u, with_tangent)) return false;
  target.has_tangent = with_tangent;
  return true;
}

} // namespace

NewtonReport newton(NewtonTarget &target, Eigen::VectorXd &u, const NewtonOptions &options) {
  NewtonReport report;
  target.exactly = options.exact_from == 0;
  if (!options.evaluated && !evaluate(target, u, true)) {
    report.reason = "a cell turned inside out before the first iteration";
    return report;
  }
  const auto relative = [&] { return target.residual().norm() / target.force_scale(); };
  double forcing = 0;
  const auto held = [&] {
    const Border *border = target.border();
    return !border || std::abs(border->constraint) <= border->tolerance;
  };
  report.residuals.push_back(relative());
  while (report.residuals.back() > options.tolerance || report.iterations == 0 || !held()) {
    if (report.iterations >= options.max_iterations) {
      report.reason = "Newton did not converge in " + std::to_string(options.max_iterations) + " iterations";
      return report;
    }
    if (stagnates(report.residuals, options.patience)) {
      report.reason = "Newton's residual hardly fell in " + std::to_string(options.patience) + " iterations";
      return report;
    }
    ++report.iterations;
    ++target.work.iterations;
    target.exactly = report.iterations >= options.exact_from;
    if (!target.has_tangent) evaluate(target, u, true);
    const bool with_tangent = !is_last(report.residuals, options.tolerance);
    forcing = forcing_term(report.residuals, forcing, options.tolerance, options.finest_forcing);
    Eigen::VectorXd change;
    LinearSolver &solver = target.solver(); // a factor of an earlier solution, or of another step, may still serve
    if (options.stale_factor && !solver.worn) {
      change = solver.solve(-target.residual(), forcing, most_linear_iterations);
      target.work.linear_iterations += solver.last_iterations();
      solver.worn = solver.last_iterations() > worn_after;
    }
    if (change.size() == 0) {
      change = solver.solve_anew(-target.residual(), forcing, most_linear_iterations);
      target.work.linear_iterations += solver.last_iterations();
      ++target.work.factorisations;
      solver.worn = false;
    }
    if (change.size() == 0 || !change.allFinite()) {
      report.reason = "the tangent is singular: is every body held by supports or contact?";
      return report;
    }
    Border *border = target.border();
    const auto multiplier_change =
        border && change.size() && change.allFinite() ? add_border(*border, solver, forcing, change) : 0.0;
    const double multiplier = border ? border->multiplier : 0;
    if (!multiplier_change) {
      report.reason = "the tangent with its constraint is singular";
      return report;
    }
    const auto go = [&](const Eigen::VectorXd &from, double factor) {
      u = from + factor * change;
      if (border) border->multiplier = multiplier + factor * *multiplier_change;
      return evaluate(target, u, with_tangent);
    };
    // Bounded backtracking: contact is not smooth, so the best step found is taken when none is better. The
    // first change carries the step's loading, its residual is no measure: any admissible one will do.
    const Eigen::VectorXd start = u;
    const double before = report.residuals.back();
    double best = -1, best_factor = 0, factor = 1;
    for (int trial = 0; trial <= options.max_backtracks; ++trial, factor /= 2) {
      if (trial > 0) ++target.work.backtracks;
      if (!go(start, factor)) continue;
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
    if (u != start + best_factor * change) go(start, best_factor);
    report.residuals.push_back(best);
  }
  report.converged = true;
  return report;
}

} // namespace rimpact::fe
