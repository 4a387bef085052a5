/// PETSc's flexible GMRES in double precision on a matrix of ours, by one rank, or by all of them for an unsymmetric
/// matrix that they share: right sides and solutions are whole on each. Flexible, because a preconditioner in single
/// precision rounds every vector anew: what it made of each is kept and combined, and the residual that decides is the
/// true one.
#pragma once
#include "fe_contact/solver/general_matrix.h"
#include "fe_contact/solver/mumps_factor.h"
#include <functional>
#include <memory>

namespace rimpact::fe {

class FlexibleGmres {
public:
  /// In place, whole on each rank.
  using Preconditioner = std::function<void(std::vector<double> &)>;
  /// Keeps a reference: the matrix's pattern must not change during this object's life.
  FlexibleGmres(SymmetricMatrix &matrix, Preconditioner preconditioner);
  FlexibleGmres(GeneralMatrix &matrix, Preconditioner preconditioner);
  ~FlexibleGmres();
  bool by_all_ranks() const;
  /// What this rank hands in of the matrix: places, and values as they were when last taken.
  const MatrixPattern &pattern() const;
  const double *values() const { return values_; }
  /// Takes the matrix's values as they stand. To be called whenever they changed.
  void take_values();
  /// To a relative residual. Empty when that takes more than `max_iterations`.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side, double relative, int max_iterations);
  int last_iterations() const { return last_iterations_; }

private:
  void set_up();
  struct Petsc;
  struct Rows;
  std::unique_ptr<Petsc> petsc_;
  std::unique_ptr<Rows> rows_; ///< with several ranks only
  const double *values_;
  int last_iterations_ = 0;
};

} // namespace rimpact::fe
