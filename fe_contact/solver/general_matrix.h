/// Unsymmetric sparse matrix with a symmetric pattern, by rows: what frictional contact adds to a tangent. The pattern
/// is fixed, rows may be empty; an entry outside the pattern is an error in every build.
#pragma once
#include "fe_contact/solver/sparsity.h"
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

class GeneralMatrix {
public:
  GeneralMatrix(int n, const Couplings &couplings);
  GeneralMatrix(const GeneralMatrix &) = delete;

  int n() const { return static_cast<int>(sparsity_.offsets.size()) - 1; }
  void set_zero();
  /// Throws std::logic_error outside the pattern.
  void add(int row, int column, double value);
  /// A dense block of some equations in ascending order, which may repeat. Throws as add does.
  void add_block(const std::vector<int> &equations, const Eigen::MatrixXd &block);
  void clear_row(int row);
  double diagonal(int row) const { return diagonals_[row] < 0 ? 0.0 : values_[diagonals_[row]]; }
  /// y gains the product with x.
  void add_product(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

  const std::vector<int> &offsets() const { return sparsity_.offsets; }
  const std::vector<int> &columns() const { return sparsity_.columns; }
  const std::vector<double> &values() const { return values_; }

private:
  Sparsity sparsity_;
  std::vector<int> diagonals_; ///< where they stand, -1: not in the pattern
  std::vector<char> filled_;   ///< rows that something was added to; most are not, of contact that is only near
  std::vector<double> values_;
};

} // namespace rimpact::fe
