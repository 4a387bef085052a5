#include "fe_contact/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace rimpact::fe {

double forcing_term(const std::vector<double> &residuals, double last, const NewtonOptions &options) {
  const double largest = residuals.size() < 2 ? options.first_forcing : 1e-2;
  constexpr double gamma = 0.9;
  // What falls below the tolerance anyhow need not be solved further (Kelley 1995).
  const double enough = std::min(largest, std::max(options.finest_forcing, 0.3 * options.tolerance / residuals.back()));
  // A solution taken up again, its multipliers changed, starts near: Dembo, Eisenstat and Steihaug's choice.
  if (residuals.size() < 2) return std::clamp(residuals.back(), enough, largest);
  const double ratio = residuals.back() / residuals[residuals.size() - 2];
  const double safeguard = gamma * last * last;
  const double term = std::max(gamma * ratio * ratio, safeguard > 0.1 ? safeguard : 0.0);
  return std::clamp(term, enough, largest);
}

namespace {

/// How u and the border's multiplier are to change.
struct Direction {
  Eigen::VectorXd change;
  double multiplier_change = 0;
};

/// The change by a factor of an earlier solution, or of another step, where that serves; else by a new one. Empty: the
/// tangent is singular.
Eigen::VectorXd solve_tangent(NewtonTarget &target, double forcing, bool stale_factor) {
  Eigen::VectorXd change;
  LinearSolver &solver = target.solver();
  if (stale_factor && !solver.needs_refactorisation) {
    change = solver.solve(-target.residual(), forcing, most_linear_iterations);
    target.work.linear_iterations += solver.last_iterations();
    solver.needs_refactorisation = solver.last_iterations() > refactorise_after;
  }
  if (change.size() == 0) {
    change = solver.solve_anew(-target.residual(), forcing, most_linear_iterations);
    target.work.linear_iterations += solver.last_iterations();
    ++target.work.factorisations;
    solver.needs_refactorisation = false;
  }
  if (change.size() > 0 && !change.allFinite()) change.resize(0);
  return change;
}

/// Makes the direction that of the bordered system. False: with its constraint the tangent is singular.
bool add_border(const BorderingConstraint &border, LinearSolver &solver, double forcing, Direction &direction) {
  const Eigen::VectorXd response = solver.solve(border.push, forcing, most_linear_iterations);
  if (response.size() == 0) return false;
  direction.multiplier_change =
      (-border.constraint - border.gradient.dot(direction.change)) / border.gradient.dot(response);
  direction.change += direction.multiplier_change * response;
  return true;
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

double relative_residual(const NewtonTarget &target) {
  return target.residual().norm() / target.force_scale();
}

bool holds_constraint(NewtonTarget &target) {
  const BorderingConstraint *border = target.border();
  return !border || std::abs(border->constraint) <= border->tolerance;
}

/// Goes along the direction as far as the residual falls, at most the whole way: bounded backtracking. Contact is not
/// smooth, so the best trial is taken where none is better than `before`; the first change of a solution carries the
/// step's loading, and any admissible trial of it will do. Returns the residual reached; none: every trial turned a
/// cell inside out.
std::optional<double> backtrack(NewtonTarget &target, Eigen::VectorXd &u, const Direction &direction, double before,
                                bool is_first, bool with_tangent, int most) {
  BorderingConstraint *border = target.border();
  const Eigen::VectorXd start = u;
  const double multiplier = border ? border->multiplier : 0;
  const auto go = [&](double factor) {
    u = start + factor * direction.change;
    if (border) border->multiplier = multiplier + factor * direction.multiplier_change;
    return evaluate(target, u, with_tangent);
  };
  double best = -1, best_factor = 0, factor = 1, last = 0;
  for (int trial = 0; trial <= most; ++trial, factor /= 2) {
    if (trial > 0) ++target.work.backtracks;
    last = factor;
    if (!go(factor)) continue;
    const double reached = relative_residual(target);
    if (best_factor == 0 || reached < best) best = reached, best_factor = factor;
    if (is_first || reached < before) break;
  }
  if (best_factor == 0 || !std::isfinite(best)) return {};
  if (last != best_factor) go(best_factor);
  return best;
}

/// A change that leaves much of the residual has met what bends, mostly in a few equations: these are solved by
/// themselves before the next change of all. Returns the residual reached.
double eliminate(NewtonTarget &target, Eigen::VectorXd &u, double before, double reached, double tolerance) {
  constexpr double much = 0.1, far = 10; // of the residual before; tolerances
  if (!target.has_tangent || reached < much * before || reached < far * tolerance) return reached;
  const Eigen::VectorXd start = u;
  if (!target.eliminate(u)) return reached;
  ++target.work.eliminations;
  target.exactly = false; // the tangents elsewhere were made just now
  if (evaluate(target, u, true))
    if (const double left = relative_residual(target); left < reached) return left;
  u = start;
  evaluate(target, u, true);
  return reached;
}

/// One iteration: the direction, and how far to go. Converged: there is a next residual.
NewtonOutcome iterate(NewtonTarget &target, Eigen::VectorXd &u, const NewtonOptions &options, NewtonReport &report,
                      double &forcing) {
  ++report.iterations;
  ++target.work.iterations;
  target.exactly = report.iterations >= options.exact_from;
  if (!target.has_tangent) evaluate(target, u, true);
  const bool with_tangent = !is_last(report.residuals, options.tolerance);
  forcing = forcing_term(report.residuals, forcing, options);
  Direction direction{solve_tangent(target, forcing, options.stale_factor)};
  if (direction.change.size() == 0) return NewtonOutcome::singular_tangent;
  const BorderingConstraint *border = target.border();
  if (border && !add_border(*border, target.solver(), forcing, direction)) return NewtonOutcome::singular_constraint;
  const auto reached = backtrack(target, u, direction, report.residuals.back(), report.iterations == 1, with_tangent,
                                 options.max_backtracks);
  if (!reached) return NewtonOutcome::inverted_cell;
  const double left =
      options.eliminates ? eliminate(target, u, report.residuals.back(), *reached, options.tolerance) : *reached;
  report.residuals.push_back(left);
  return NewtonOutcome::converged;
}

} // namespace

std::string NewtonReport::reason() const {
  using enum NewtonOutcome;
  switch (outcome) {
  case converged:
    return fmt::format("Newton converged in {} iterations", iterations);
  case inverted_at_start:
    return "a cell turned inside out before the first iteration";
  case inverted_cell:
    return "a cell turned inside out";
  case spent:
    return fmt::format("Newton did not converge in {} iterations", iterations);
  case stagnant:
    return fmt::format("Newton's residual hardly fell any more, after {} iterations", iterations);
  case singular_tangent:
    return "the tangent is singular: is every body held by supports or contact?";
  case singular_constraint:
    return "the tangent with its constraint is singular";
  }
  return "unknown"; // a bug: every outcome has a sentence
}

NewtonReport newton(NewtonTarget &target, Eigen::VectorXd &u, const NewtonOptions &options) {
  NewtonReport report;
  const auto end = [&](NewtonOutcome outcome) {
    report.outcome = outcome;
    return report;
  };
  target.exactly = options.exact_from == 0;
  if (!options.evaluated && !evaluate(target, u, true)) return end(NewtonOutcome::inverted_at_start);
  report.residuals.push_back(relative_residual(target));
  double forcing = 0;
  while (report.residuals.back() > options.tolerance || report.iterations == 0 || !holds_constraint(target)) {
    if (report.iterations >= options.max_iterations) return end(NewtonOutcome::spent);
    if (stagnates(report.residuals, options.patience)) return end(NewtonOutcome::stagnant);
    if (const auto outcome = iterate(target, u, options, report, forcing); outcome != NewtonOutcome::converged)
      return end(outcome);
  }
  return end(NewtonOutcome::converged);
}

} // namespace rimpact::fe
