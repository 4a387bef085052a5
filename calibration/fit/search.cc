#include "calibration/fit/search.h"
#include "calibration/fit/bounded_search.h"
#include <algorithm>

namespace rimpact::calibration {

namespace {

class Cost final : public ceres::CostFunction {
public:
  Cost(const Problem &problem, const ResidualBlock &block) : problem_(problem), block_(block) {
    set_num_residuals(block.size());
    mutable_parameter_block_sizes()->push_back(problem.n_unknowns());
    if (block.n_nuisance() > 0) mutable_parameter_block_sizes()->push_back(block.n_nuisance());
  }
  bool Evaluate(double const *const *x, double *r, double **jacobians) const override {
    const double *nuisance = block_.n_nuisance() > 0 ? x[1] : nullptr;
    if (!problem_.residuals(block_, x[0], nuisance, r)) return false;
    if (!jacobians) return true;
    if (jacobians[0] && !problem_.jacobian(block_, x[0], nuisance, r, jacobians[0])) return false;
    return !nuisance || !jacobians[1] || problem_.nuisance_jacobian(block_, x[0], nuisance, jacobians[1]);
  }

private:
  const Problem &problem_;
  const ResidualBlock &block_;
};

/// Ends a search that creeps along a valley far above what another start has found: such valleys are long (a yielding
/// rim whose yield force is at its bound is followed for hundreds of iterations).
class GiveUp final : public ceres::IterationCallback {
public:
  explicit GiveUp(double best) : best_(best) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary &now) override {
    if (!now.step_is_successful) return ceres::SOLVER_CONTINUE; // it is tried again, shorter
    costs_.push_back(now.cost);
    const bool hopeless = now.cost > far * best_ && costs_.size() > patience &&
                          now.cost > creeping * costs_[costs_.size() - 1 - patience];
    return hopeless ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

private:
  static constexpr std::size_t patience = 5; ///< iterations
  static constexpr double creeping = 0.7;    ///< of its cost so many iterations before
  static constexpr double far = 4;           ///< times the best cost
  double best_;
  std::vector<double> costs_;
};

} // namespace

std::vector<int> held_at_bounds(const Problem &problem, const Eigen::VectorXd &x) {
  const std::vector<int> free = problem.free(x);
  std::vector<int> held;
  for (int i = 0; i < problem.n_unknowns(); ++i)
    if (std::find(free.begin(), free.end(), i) == free.end()) held.push_back(i);
  return held;
}

Ending search(const Problem &problem, Eigen::VectorXd x, const FitOptions &options, double best) {
  ceres::Problem ceres_problem;
  Nuisance nuisance; // all zero: what was known of each impact beforehand
  for (const auto &block : problem.blocks()) nuisance.push_back(Eigen::VectorXd::Zero(block->n_nuisance()));
  for (std::size_t i = 0; i < problem.blocks().size(); ++i) {
    const auto &block = problem.blocks()[i];
    ceres::LossFunction *loss = options.robust_scale > 0 ? new ceres::HuberLoss(options.robust_scale) : nullptr;
    std::vector<double *> unknowns = {x.data()};
    if (block->n_nuisance() > 0) unknowns.push_back(nuisance[i].data());
    ceres_problem.AddResidualBlock(new Cost(problem, *block), loss, unknowns);
  }
  keep_within(ceres_problem, x.data(), problem.lower(), problem.upper());
  ceres::Solver::Options solver = silent_solver(options.max_iterations);
  solver.function_tolerance = options.tolerance; // data without errors go on until the parameters stand still
  solver.gradient_tolerance = 1e-12;
  solver.parameter_tolerance = 1e-9;
  // Steps end at the bounds anyway; a search along each would ask for a second Jacobian, which is what a fit costs.
  solver.max_num_line_search_step_size_iterations = 0;
  GiveUp give_up(best);
  solver.callbacks.push_back(&give_up);
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &ceres_problem, &summary);
  const auto held = held_at_bounds(problem, x);
  const bool given_up = summary.termination_type == ceres::USER_SUCCESS;
  if (!given_up && !held.empty() && static_cast<int>(held.size()) < x.size()) {
    ceres_problem.SetManifold(x.data(), new ceres::SubsetManifold(static_cast<int>(x.size()), held));
    ceres::Solve(solver, &ceres_problem, &summary); // along a bound the first ends early
  }
  return {x,
          nuisance,
          summary.final_cost,
          summary.IsSolutionUsable(),
          summary.termination_type == ceres::CONVERGENCE,
          summary.message};
}

} // namespace rimpact::calibration
