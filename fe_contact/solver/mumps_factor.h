/// A sparse factor by MUMPS, L D L^T of a symmetric matrix or L U of an unsymmetric one, made by one rank or by all of
/// them together. As the preconditioner of an iteration in double precision a factor in single precision does as well:
/// half the memory, and half of what moves when it is made and solved with.
#pragma once
#include <memory>
#include <vector>

namespace rimpact::fe {

/// Entries a rank hands in, indices from 0; of a symmetric matrix one triangle.
struct MatrixPattern {
  int n = 0;
  bool symmetric = false;
  std::vector<int> rows, columns;
};

/// What this rank has of a factor: floating-point operations, entries it keeps, and entries of the matrix it hands in.
struct FactorWork {
  double operations = 0, entries = 0, handed_in = 0;
};

class MumpsFactor {
public:
  virtual ~MumpsFactor() = default;
  /// `values` in the order of the pattern. False when the matrix is singular or memory runs out.
  virtual bool factorise(const double *values) = 0;
  /// The right side, whole on each rank, becomes the solution. Only after factorise() succeeded.
  virtual void solve(std::vector<double> &x) = 0;
  virtual FactorWork work() const = 0; ///< of the last factorise()
};

enum class Precision { single_, double_ };
std::unique_ptr<MumpsFactor> mumps_factor(Precision precision, const MatrixPattern &pattern, bool by_all_ranks);

} // namespace rimpact::fe
