/// Newton's method for R(u) = 0: bounded backtracking, a stale factor inside GMRES with Eisenstat-Walker's
/// forcing terms, and a report of every residual. Knows functions, not bearings.
#pragma once
#include "fe_contact/solver/linear_solver.h"
#include "fe_contact/solver/solver_work.h"
#include <Eigen/Core>
#include <string>
#include <vector>

namespace rimpact::fe {

/// One more unknown and the equation that determines it: a multiplier and its constraint, bordering the tangent.
struct BorderingConstraint {
  Eigen::VectorXd push;     ///< -d residual / d multiplier
  Eigen::VectorXd gradient; ///< d constraint / d u
  double constraint = 0, tolerance = 0, multiplier = 0;
};

class NewtonTarget {
public:
  virtual ~NewtonTarget() = default;
  /// Residual and, unless it is not asked for, tangent at u; false where a law finds u inadmissible (the step must be
  /// shortened).
  virtual bool evaluate(const Eigen::VectorXd &u, bool with_tangent) = 0;
  bool has_tangent = false; ///< of the last evaluation
  bool exactly = false;     ///< the next tangent is to hold nothing kept from other evaluations
  virtual const Eigen::VectorXd &residual() const = 0;
  /// Solves a few equations that keep most of the residual by themselves, where that can be done: u moves there. To be
  /// called where the target stands evaluated at u with its tangent. False: u is as it was.
  virtual bool eliminate(Eigen::VectorXd & /*u*/) { return false; }
  /// Size of the forces in play [N], against which the residual is small or not.
  virtual double force_scale() const = 0;
  virtual LinearSolver &solver() = 0; ///< of the tangent
  /// Of the last evaluation; its multiplier is set before each. Null: none.
  virtual BorderingConstraint *border() { return nullptr; }
  TimeSplit time_split;
  SolverWork work; ///< of all solutions so far
};

struct NewtonOptions {
  double tolerance = 1e-8; ///< residual over the forces in play
  int max_iterations = 20;
  int max_backtracks = 4;
  int patience =
      0; ///< given up where the residual hardly fell (to 0.6) in so many iterations after the first; 0: never
  bool stale_factor = true; ///< false: factorise at every iteration
  /// The first linear system's largest relative residual: what is left of the loading strains small cells.
  double first_forcing = 1e-2;
  double finest_forcing = 1e-10; ///< the linear systems are never asked for a smaller relative residual
  bool evaluated = false;        ///< the target stands evaluated at u already
  bool eliminates = false;       ///< where a change leaves much of the residual, what keeps it is solved by itself
  int exact_from = 3;            ///< iterations after which tangents hold nothing kept; 0: none ever does
};

/// How a solution ended.
enum class NewtonOutcome {
  converged,
  inverted_at_start,
  inverted_cell,
  spent,
  stagnant,
  singular_tangent,
  singular_constraint
};
struct NewtonReport {
  NewtonOutcome outcome = NewtonOutcome::spent;
  int iterations = 0;
  std::vector<double> residuals; ///< relative, before each iteration and at the end
  bool converged() const { return outcome == NewtonOutcome::converged; }
  std::string reason() const; ///< a sentence on the outcome
};

/// Relative residual to which an iteration's linear system need be solved: Eisenstat and Walker (1996), choice 2 with
/// its safeguard. `residuals` so far, at least one; `last`: the term before (0: none).
double forcing_term(const std::vector<double> &residuals, double last, const NewtonOptions &options);
/// GMRES's iterations after which a factor is given up, and after which it is renewed.
inline constexpr int most_linear_iterations = 30, refactorise_after = 6;

/// From u to the solution, in place. The target stays evaluated at u.
NewtonReport newton(NewtonTarget &target, Eigen::VectorXd &u, const NewtonOptions &options);

} // namespace rimpact::fe
