/// Factorisation and solves by MUMPS through PETSc (L D L^T of a symmetric indefinite matrix). Owns its KSP.
#pragma once
#include "fe_contact/solver/symmetric_matrix.h"
#include <memory>

namespace rimpact::fe {

class DirectSolver {
public:
  /// Keeps a reference: the matrix's pattern must not change during the solver's life.
  explicit DirectSolver(SymmetricMatrix &matrix);
  ~DirectSolver();
  /// Factorises the matrix's present values. False when MUMPS finds it singular or runs out of memory.
  bool factorise();
  /// Solves with the last factorisation.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side);

private:
  struct Petsc;
  std::unique_ptr<Petsc> petsc_;
};

} // namespace rimpact::fe
