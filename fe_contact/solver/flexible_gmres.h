/// PETSc's flexible GMRES in double precision on whole vectors. Flexible, because a preconditioner in single precision
/// rounds every vector anew: what it made of each is kept and combined, and the residual that decides is the true one.
/// Several ranks do the same together: the first one's residual decides for all, and all take its solution, for their
/// processors may round differently.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <memory>

namespace rimpact::fe {

class FlexibleGmres {
public:
  /// A vector to its image.
  using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd &)>;
  FlexibleGmres(int n, Operator matrix, Operator preconditioner);
  ~FlexibleGmres();
  /// To a relative residual. Empty when that takes more than `max_iterations`.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  int last_iterations() const { return last_iterations_; }

private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
  int last_iterations_ = 0;
};

} // namespace rimpact::fe
