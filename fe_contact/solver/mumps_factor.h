/// A sparse factor by MUMPS, L D L^T of a symmetric matrix or L U of an unsymmetric one, made by all ranks
/// together. As the preconditioner of an iteration in double precision a factor in single precision does as well: half
/// the memory, and half of what moves when it is made and solved with.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

namespace rimpact::fe {

/// Entries a rank hands in, indices from 0; of a symmetric matrix one triangle. Entries that stand at the same place,
/// of one rank or of several, are summed up.
struct MatrixPattern {
  int n = 0;
  bool symmetric = false;
  std::vector<int> rows, columns;
};

/// What this rank has of a factor: floating-point operations, entries it keeps, and entries that it hands in, each
/// counted where several stand at one place.
struct FactorWork {
  double operations = 0, entries = 0, handed_in = 0;
};

class MumpsFactor {
public:
  virtual ~MumpsFactor() = default;
  /// `values` in the order of the pattern. False when the matrix is singular or memory runs out.
  virtual bool factorise(const double *values) = 0;
  /// Solves for a right side; both vectors are whole on each rank. Only after factorise() succeeded.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd &right_side) = 0;
  virtual FactorWork work() const = 0; ///< of the last factorise()
};

enum class Precision { single_, double_ };
std::unique_ptr<MumpsFactor> mumps_factor(Precision precision, const MatrixPattern &pattern);

} // namespace rimpact::fe
