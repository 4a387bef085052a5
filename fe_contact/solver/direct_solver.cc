#include "fe_contact/solver/direct_solver.h"

#include <petscksp.h>
#include <stdexcept>

namespace rimpact::fe {
namespace {
void check(PetscErrorCode code) {
  if (code) throw std::runtime_error("PETSc failed with code " + std::to_string(code));
}
} // namespace

struct DirectSolver::Petsc {
  Mat matrix = nullptr;
  KSP ksp = nullptr;
  Vec b = nullptr, x = nullptr;
};

DirectSolver::DirectSolver(SymmetricMatrix &matrix) : petsc_(std::make_unique<Petsc>()) {
  const int n = matrix.n();
  check(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, n, n, matrix.starts().data(), matrix.columns().data(),
                                    matrix.values().data(), &petsc_->matrix));
  set_up(true, n);
}

DirectSolver::DirectSolver(GeneralMatrix &matrix) : petsc_(std::make_unique<Petsc>()) {
  const int n = matrix.n();
  check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, matrix.starts().data(), matrix.columns().data(),
                                  matrix.values().data(), &petsc_->matrix));
  set_up(false, n);
}

void DirectSolver::set_up(bool symmetric, int n) {
  auto &p = *petsc_;
  check(MatSetOption(p.matrix, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  check(KSPCreate(PETSC_COMM_SELF, &p.ksp));
  check(KSPSetType(p.ksp, KSPPREONLY));
  PC pc;
  check(KSPGetPC(p.ksp, &pc));
  check(PCSetType(pc, symmetric ? PCCHOLESKY : PCLU));
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  check(KSPSetOperators(p.ksp, p.matrix, p.matrix));
  check(PCFactorSetUpMatSolverType(pc));
  Mat factor;
  check(PCFactorGetMatrix(pc, &factor));
  check(MatMumpsSetIcntl(factor, 7, 5));   // METIS ordering
  check(MatMumpsSetIcntl(factor, 14, 50)); // room for pivoting [%]
  check(VecCreateSeq(PETSC_COMM_SELF, n, &p.b));
  check(VecDuplicate(p.b, &p.x));
}

DirectSolver::~DirectSolver() {
  auto &p = *petsc_;
  VecDestroy(&p.x);
  VecDestroy(&p.b);
  KSPDestroy(&p.ksp);
  MatDestroy(&p.matrix);
}

bool DirectSolver::factorise() {
  auto &p = *petsc_;
  check(MatAssemblyBegin(p.matrix, MAT_FINAL_ASSEMBLY)); // the values changed behind PETSc's back: tell it
  check(MatAssemblyEnd(p.matrix, MAT_FINAL_ASSEMBLY));
  check(KSPSetReusePreconditioner(p.ksp, PETSC_FALSE));
  check(KSPSetOperators(p.ksp, p.matrix, p.matrix));
  check(KSPSetUp(p.ksp));
  PC pc;
  check(KSPGetPC(p.ksp, &pc));
  PCFailedReason reason;
  check(PCGetFailedReason(pc, &reason));
  has_factor_ = reason == PC_NOERROR;
  return has_factor_;
}

Eigen::VectorXd DirectSolver::solve(const Eigen::VectorXd &right_side) {
  check(KSPSetType(petsc_->ksp, KSPPREONLY));
  return solve_by_ksp(right_side);
}

Eigen::VectorXd DirectSolver::solve_iteratively(const Eigen::VectorXd &right_side, double relative,
                                                int max_iterations) {
  auto &p = *petsc_;
  check(MatAssemblyBegin(p.matrix, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(p.matrix, MAT_FINAL_ASSEMBLY));
  check(KSPSetReusePreconditioner(p.ksp, PETSC_TRUE));
  check(KSPSetType(p.ksp, KSPGMRES));
  check(KSPGMRESSetRestart(p.ksp, max_iterations));
  check(KSPSetPCSide(p.ksp, PC_RIGHT)); // the true residual decides
  check(KSPSetTolerances(p.ksp, relative, 0.0, PETSC_DEFAULT, max_iterations));
  check(KSPSetOperators(p.ksp, p.matrix, p.matrix));
  Eigen::VectorXd result = solve_by_ksp(right_side);
  KSPConvergedReason reason;
  check(KSPGetConvergedReason(p.ksp, &reason));
  PetscInt iterations;
  check(KSPGetIterationNumber(p.ksp, &iterations));
  last_iterations_ = iterations;
  if (reason < 0) return {};
  return result;
}

Eigen::VectorXd DirectSolver::solve_by_ksp(const Eigen::VectorXd &right_side) {
  auto &p = *petsc_;
  PetscScalar *data;
  check(VecGetArray(p.b, &data));
  std::copy(right_side.data(), right_side.data() + right_side.size(), data);
  check(VecRestoreArray(p.b, &data));
  check(KSPSolve(p.ksp, p.b, p.x));
  Eigen::VectorXd result(right_side.size());
  check(VecGetArray(p.x, &data));
  std::copy(data, data + result.size(), result.data());
  check(VecRestoreArray(p.x, &data));
  return result;
}

} // namespace rimpact::fe
