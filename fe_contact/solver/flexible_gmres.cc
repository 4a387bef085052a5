#include "fe_contact/solver/flexible_gmres.h"

#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <petscksp.h>
#include <stdexcept>

namespace rimpact::fe {
namespace {

void check(PetscErrorCode code) {
  if (code) throw std::runtime_error("PETSc failed with code " + std::to_string(code));
}

Eigen::VectorXd values_of(Vec vector) {
  PetscInt n;
  const PetscScalar *values;
  check(VecGetLocalSize(vector, &n));
  check(VecGetArrayRead(vector, &values));
  Eigen::VectorXd result = Eigen::Map<const Eigen::VectorXd>(values, n);
  check(VecRestoreArrayRead(vector, &values));
  return result;
}

void set_values(Vec vector, const Eigen::VectorXd &from) {
  PetscScalar *values;
  check(VecGetArray(vector, &values));
  std::copy(from.begin(), from.end(), values);
  check(VecRestoreArray(vector, &values));
}

} // namespace

struct FlexibleGmres::Petsc {
  Operator matrix, preconditioner;
  void *usual_test = nullptr;
  Mat shell = nullptr;
  KSP ksp = nullptr;
  Vec b = nullptr, x = nullptr;

  static PetscErrorCode multiply(Mat shell, Vec x, Vec result) {
    Petsc *self;
    check(MatShellGetContext(shell, &self));
    set_values(result, self->matrix(values_of(x)));
    return 0;
  }
  static PetscErrorCode precondition(PC pc, Vec right, Vec result) {
    Petsc *self;
    check(PCShellGetContext(pc, &self));
    set_values(result, self->preconditioner(values_of(right)));
    return 0;
  }
  static PetscErrorCode test(KSP ksp, PetscInt iteration, PetscReal residual, KSPConvergedReason *reason, void *data) {
    const auto *self = static_cast<const Petsc *>(data);
    return KSPConvergedDefault(ksp, iteration, ranks().broadcast(residual), reason, self->usual_test);
  }
};

FlexibleGmres::FlexibleGmres(int n, Operator matrix, Operator preconditioner)
    : petsc_(std::make_unique<Petsc>(Petsc{std::move(matrix), std::move(preconditioner)})) {
  auto &p = *petsc_;
  check(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, &p, &p.shell));
  check(MatShellSetOperation(p.shell, MATOP_MULT, reinterpret_cast<void (*)()>(Petsc::multiply)));
  check(MatCreateVecs(p.shell, &p.x, &p.b));
  check(KSPCreate(PETSC_COMM_SELF, &p.ksp));
  check(KSPSetType(p.ksp, KSPFGMRES));
  check(KSPSetOperators(p.ksp, p.shell, p.shell));
  check(KSPConvergedDefaultCreate(&p.usual_test));
  check(KSPSetConvergenceTest(p.ksp, Petsc::test, &p, nullptr));
  PC pc;
  check(KSPGetPC(p.ksp, &pc));
  check(PCSetType(pc, PCSHELL));
  check(PCShellSetContext(pc, &p));
  check(PCShellSetApply(pc, Petsc::precondition));
}

FlexibleGmres::~FlexibleGmres() {
  auto &p = *petsc_;
  VecDestroy(&p.x);
  VecDestroy(&p.b);
  KSPDestroy(&p.ksp);
  KSPConvergedDefaultDestroy(p.usual_test);
  MatDestroy(&p.shell);
}

Eigen::VectorXd FlexibleGmres::solve(const Eigen::VectorXd &right_side, double relative, int max_iterations) {
  auto &p = *petsc_;
  check(KSPGMRESSetRestart(p.ksp, max_iterations));
  check(KSPSetTolerances(p.ksp, relative, 0.0, PETSC_DEFAULT, max_iterations));
  set_values(p.b, right_side);
  check(KSPSolve(p.ksp, p.b, p.x));
  KSPConvergedReason reason;
  check(KSPGetConvergedReason(p.ksp, &reason));
  PetscInt iterations;
  check(KSPGetIterationNumber(p.ksp, &iterations));
  last_iterations_ = iterations;
  if (reason < 0) return {};
  Eigen::VectorXd result = values_of(p.x);
  ranks().broadcast(result);
  return result;
}

} // namespace rimpact::fe
