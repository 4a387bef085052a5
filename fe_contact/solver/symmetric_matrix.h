/// Symmetric sparse matrix, upper triangle by rows (CSR), with a pattern that is fixed until it is rebuilt.
/// An entry outside the pattern is an error in every build: nothing is dropped in silence.
#pragma once
#include <algorithm>
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

class SymmetricMatrix {
public:
  SymmetricMatrix(const SymmetricMatrix &) = delete; // a copy would share the pattern's identity
  /// Each clique is a list of equations coupled with one another (-1 entries are skipped).
  SymmetricMatrix(int n, const std::vector<std::vector<int>> &couplings);

  int n() const { return n_; }
  /// Differs between any two patterns ever made: caches of places compare it.
  long pattern_id() const { return pattern_id_; }
  std::size_t n_entries() const { return columns_.size(); }
  /// Place of entry (row, column), row <= column, or -1.
  int find(int row, int column) const;
  /// Adds to entry (i, j) or (j, i), whichever is stored; throws std::logic_error outside the pattern.
  void add(int i, int j, double value);
  void set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }
  double diagonal(int i) const { return values_[offsets_[i]]; }
  Eigen::VectorXd multiply(const Eigen::VectorXd &x) const;
  /// Makes row and column `i` the unit row scaled by `diagonal` (i must be smaller than every other coupled
  /// index that matters, as masters are: only the stored row is cleared).
  void make_unit_row(int i, double diagonal);

  std::vector<int> &offsets() { return offsets_; }
  std::vector<int> &columns() { return columns_; }
  std::vector<double> &values() { return values_; }
  const std::vector<int> &offsets() const { return offsets_; }
  const std::vector<int> &columns() const { return columns_; }
  const std::vector<double> &values() const { return values_; }

private:
  int n_;
  long pattern_id_;
  std::vector<int> offsets_, columns_;
  std::vector<double> values_;
};

} // namespace rimpact::fe
