/// Unsymmetric sparse matrix with a symmetric pattern, by rows (CSR): the tangent of frictional contact. The
/// pattern is fixed; an entry outside it is an error in every build.
#pragma once
#include "fe_contact/solver/symmetric_matrix.h"

namespace rimpact::fe {

class GeneralMatrix {
public:
  /// Both triangles of a symmetric matrix's pattern.
  explicit GeneralMatrix(const SymmetricMatrix &pattern);
  GeneralMatrix(const GeneralMatrix &) = delete;

  int n() const { return static_cast<int>(offsets_.size()) - 1; }
  /// Takes the values of a symmetric matrix with the pattern this one was made from. A row without diagonal is empty.
  void assign(const SymmetricMatrix &symmetric);
  /// Throws std::logic_error outside the pattern.
  void add(int row, int column, double value);
  /// Values at columns of one row, ascending: found in one walk along it. Throws as add does.
  void add_row(int row, const std::vector<int> &columns, const double *values);
  /// The row becomes `diagonal` times the unit row.
  void make_unit_row(int row, double diagonal);
  double diagonal(int row) const { return values_[diagonals_[row]]; }
  Eigen::VectorXd multiply(const Eigen::VectorXd &x) const;

  std::vector<int> &offsets() { return offsets_; }
  std::vector<int> &columns() { return columns_; }
  std::vector<double> &values() { return values_; }
  const std::vector<int> &offsets() const { return offsets_; }
  const std::vector<int> &columns() const { return columns_; }
  const std::vector<double> &values() const { return values_; }

private:
  int entry_of(int row, int column) const;
  std::vector<int> offsets_, columns_;
  std::vector<int> diagonals_; ///< where they stand
  std::vector<int> from_;      ///< which entry of the symmetric matrix each takes
  std::vector<double> values_;
};

} // namespace rimpact::fe
