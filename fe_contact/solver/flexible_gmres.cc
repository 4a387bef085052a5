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

MatrixPattern pattern_of(const std::vector<int> &offsets, const std::vector<int> &columns, bool symmetric,
                         std::size_t first, std::size_t last) {
  MatrixPattern result{static_cast<int>(offsets.size()) - 1,
                       symmetric,
                       {},
                       {columns.begin() + offsets[first], columns.begin() + offsets[last]}};
  result.rows.reserve(result.columns.size());
  for (std::size_t row = first; row < last; ++row)
    result.rows.insert(result.rows.end(), offsets[row + 1] - offsets[row], static_cast<int>(row));
  return result;
}

} // namespace

struct FlexibleGmres::Petsc {
  MatrixPattern pattern;
  Preconditioner preconditioner;
  Mat matrix = nullptr;
  KSP ksp = nullptr;
  Vec b = nullptr, x = nullptr;
  std::vector<std::size_t> of_rank; ///< where each rank's rows begin
  std::vector<double> whole;        ///< a vector on its way through the factor

  bool shared() const { return of_rank.size() > 2; }
  /// What the ranks hold of a vector, put together on each.
  void gather(Vec part, double *result) const;
  void scatter(const double *values, Vec part) const;
  static PetscErrorCode precondition(PC pc, Vec right, Vec result);
};

void FlexibleGmres::Petsc::gather(Vec part, double *result) const {
  PetscInt first, last;
  const PetscScalar *own;
  check(VecGetOwnershipRange(part, &first, &last));
  check(VecGetArrayRead(part, &own));
  std::copy(own, own + (last - first), result + first);
  check(VecRestoreArrayRead(part, &own));
  if (shared()) ranks().all_gather_bytes(result, sizeof(double), of_rank);
}

void FlexibleGmres::Petsc::scatter(const double *values, Vec part) const {
  PetscInt first, last;
  PetscScalar *own;
  check(VecGetOwnershipRange(part, &first, &last));
  check(VecGetArray(part, &own));
  std::copy(values + first, values + last, own);
  check(VecRestoreArray(part, &own));
}

PetscErrorCode FlexibleGmres::Petsc::precondition(PC pc, Vec right, Vec result) {
  Petsc *self;
  check(PCShellGetContext(pc, &self));
  self->gather(right, self->whole.data());
  self->preconditioner(self->whole);
  self->scatter(self->whole.data(), result);
  return 0;
}

/// The rows of a matrix that this rank solves for; of each entry every rank has a part, until they are summed up.
struct FlexibleGmres::Rows {
  GeneralMatrix &parts;
  std::vector<std::size_t> of_rank, entries_of_rank; ///< where each rank's begin
  std::vector<int> offsets;
  explicit Rows(GeneralMatrix &parts) : parts(parts), of_rank(ranks().offsets(parts.n())) {
    for (const std::size_t row : of_rank) entries_of_rank.push_back(parts.offsets()[row]);
    const std::size_t first = of_rank[ranks().own], last = of_rank[ranks().own + 1];
    for (std::size_t row = first; row <= last; ++row) offsets.push_back(parts.offsets()[row] - parts.offsets()[first]);
  }
  int n() const { return static_cast<int>(offsets.size()) - 1; }
  double *values() const { return parts.values().data() + entries_of_rank[ranks().own]; }
  const int *columns() const { return parts.columns().data() + entries_of_rank[ranks().own]; }
};

FlexibleGmres::FlexibleGmres(SymmetricMatrix &matrix, Preconditioner preconditioner)
    : petsc_(std::make_unique<Petsc>()), values_(matrix.values().data()) {
  petsc_->preconditioner = std::move(preconditioner);
  const int n = matrix.n();
  check(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, n, n, matrix.offsets().data(), matrix.columns().data(),
                                    matrix.values().data(), &petsc_->matrix));
  petsc_->of_rank = {0, std::size_t(n)};
  petsc_->pattern = pattern_of(matrix.offsets(), matrix.columns(), true, 0, n);
  set_up();
}

FlexibleGmres::FlexibleGmres(GeneralMatrix &matrix, Preconditioner preconditioner)
    : petsc_(std::make_unique<Petsc>()), rows_(ranks().size > 1 ? std::make_unique<Rows>(matrix) : nullptr),
      values_(rows_ ? rows_->values() : matrix.values().data()) {
  petsc_->preconditioner = std::move(preconditioner);
  const int n = matrix.n();
  petsc_->of_rank = ranks().offsets(n);
  if (rows_)
    check(MatCreateMPIAIJWithArrays(PETSC_COMM_WORLD, rows_->n(), rows_->n(), n, n, rows_->offsets.data(),
                                    rows_->columns(), rows_->values(), &petsc_->matrix));
  else
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, matrix.offsets().data(), matrix.columns().data(),
                                    matrix.values().data(), &petsc_->matrix));
  petsc_->pattern = pattern_of(matrix.offsets(), matrix.columns(), false, petsc_->of_rank[ranks().own],
                               petsc_->of_rank[ranks().own + 1]);
  set_up();
}

void FlexibleGmres::set_up() {
  auto &p = *petsc_;
  p.whole.resize(p.pattern.n);
  check(MatSetOption(p.matrix, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  check(MatCreateVecs(p.matrix, &p.x, &p.b));
  check(KSPCreate(p.shared() ? PETSC_COMM_WORLD : PETSC_COMM_SELF, &p.ksp));
  check(KSPSetType(p.ksp, KSPFGMRES));
  check(KSPSetOperators(p.ksp, p.matrix, p.matrix));
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
  MatDestroy(&p.matrix);
}

void FlexibleGmres::take_values() {
  auto &p = *petsc_;
  if (rows_) {
    ranks().reduce_scatter(rows_->parts.values(), rows_->entries_of_rank);
    check(MatUpdateMPIAIJWithArray(p.matrix, rows_->values()));
    return;
  }
  check(MatAssemblyBegin(p.matrix, MAT_FINAL_ASSEMBLY)); // the values changed behind PETSc's back: tell it
  check(MatAssemblyEnd(p.matrix, MAT_FINAL_ASSEMBLY));
}

bool FlexibleGmres::by_all_ranks() const {
  return petsc_->shared();
}
const MatrixPattern &FlexibleGmres::pattern() const {
  return petsc_->pattern;
}

Eigen::VectorXd FlexibleGmres::solve(const Eigen::VectorXd &right_side, double relative, int max_iterations) {
  auto &p = *petsc_;
  check(KSPGMRESSetRestart(p.ksp, max_iterations));
  check(KSPSetTolerances(p.ksp, relative, 0.0, PETSC_DEFAULT, max_iterations));
  p.scatter(right_side.data(), p.b);
  check(KSPSolve(p.ksp, p.b, p.x));
  KSPConvergedReason reason;
  check(KSPGetConvergedReason(p.ksp, &reason));
  PetscInt iterations;
  check(KSPGetIterationNumber(p.ksp, &iterations));
  last_iterations_ = iterations;
  if (reason < 0) return {};
  Eigen::VectorXd result(right_side.size());
  p.gather(p.x, result.data());
  return result;
}

} // namespace rimpact::fe
