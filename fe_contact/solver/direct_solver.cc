#include "fe_contact/solver/direct_solver.h"

#include "fe_contact/solver/ranks.h"
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

/// The rows of a matrix that this rank solves for; of each entry every rank has a part.
struct DirectSolver::Rows {
  const GeneralMatrix &parts;
  std::vector<std::size_t> of_rank, entries_of_rank; ///< where each rank's begin
  std::vector<int> starts;
  std::vector<double> values;
  explicit Rows(const GeneralMatrix &parts) : parts(parts), of_rank(ranks().starts(parts.n())) {
    for (const std::size_t row : of_rank) entries_of_rank.push_back(parts.starts()[row]);
    const std::size_t first = of_rank[ranks().own], last = of_rank[ranks().own + 1];
    for (std::size_t row = first; row <= last; ++row) starts.push_back(parts.starts()[row] - parts.starts()[first]);
    values.assign(starts.back(), 0.0);
  }
  int n() const { return static_cast<int>(starts.size()) - 1; }
  const int *columns() const { return parts.columns().data() + entries_of_rank[ranks().own]; }
};

DirectSolver::DirectSolver(SymmetricMatrix &matrix) : petsc_(std::make_unique<Petsc>()) {
  const int n = matrix.n();
  check(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, n, n, matrix.starts().data(), matrix.columns().data(),
                                    matrix.values().data(), &petsc_->matrix));
  set_up(true, n);
}

DirectSolver::DirectSolver(GeneralMatrix &matrix) : petsc_(std::make_unique<Petsc>()) {
  const int n = matrix.n();
  if (ranks().size == 1) {
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, matrix.starts().data(), matrix.columns().data(),
                                    matrix.values().data(), &petsc_->matrix));
    set_up(false, n);
    return;
  }
  rows_ = std::make_unique<Rows>(matrix);
  check(MatCreateMPIAIJWithArrays(PETSC_COMM_WORLD, rows_->n(), rows_->n(), n, n, rows_->starts.data(), rows_->columns(),
                                  rows_->values.data(), &petsc_->matrix));
  set_up(false, rows_->n());
}

void DirectSolver::set_up(bool symmetric, int own_rows) {
  auto &p = *petsc_;
  const MPI_Comm comm = rows_ ? PETSC_COMM_WORLD : PETSC_COMM_SELF;
  check(MatSetOption(p.matrix, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  check(KSPCreate(comm, &p.ksp));
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
  check(VecCreate(comm, &p.b));
  check(VecSetSizes(p.b, own_rows, PETSC_DETERMINE));
  check(VecSetType(p.b, VECSTANDARD));
  check(VecDuplicate(p.b, &p.x));
}

DirectSolver::~DirectSolver() {
  auto &p = *petsc_;
  VecDestroy(&p.x);
  VecDestroy(&p.b);
  KSPDestroy(&p.ksp);
  MatDestroy(&p.matrix);
}

void DirectSolver::take_values() {
  auto &p = *petsc_;
  if (rows_) {
    ranks().sum_to_owners(rows_->parts.values(), rows_->entries_of_rank, rows_->values);
    check(MatUpdateMPIAIJWithArray(p.matrix, rows_->values.data()));
    return;
  }
  check(MatAssemblyBegin(p.matrix, MAT_FINAL_ASSEMBLY)); // the values changed behind PETSc's back: tell it
  check(MatAssemblyEnd(p.matrix, MAT_FINAL_ASSEMBLY));
}

bool DirectSolver::factorise() {
  auto &p = *petsc_;
  take_values();
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
  take_values();
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
  PetscInt first, last; // own rows
  check(VecGetOwnershipRange(p.b, &first, &last));
  check(VecGetArray(p.b, &data));
  std::copy(right_side.data() + first, right_side.data() + last, data);
  check(VecRestoreArray(p.b, &data));
  check(KSPSolve(p.ksp, p.b, p.x));
  Eigen::VectorXd result(right_side.size());
  check(VecGetArray(p.x, &data));
  std::copy(data, data + (last - first), result.data() + first);
  check(VecRestoreArray(p.x, &data));
  if (rows_) ranks().hand_round_bytes(result.data(), sizeof(double), rows_->of_rank);
  return result;
}

} // namespace rimpact::fe
