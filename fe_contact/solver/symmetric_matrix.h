/// Symmetric sparse matrix, upper triangle by rows, with a fixed pattern. An entry outside the pattern is an error in
/// every build: nothing is dropped in silence.
#pragma once
#include "fe_contact/solver/sparsity.h"
#include <algorithm>
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

class SymmetricMatrix {
public:
  SymmetricMatrix(SymmetricMatrix &&) = default; // no copies: one would share the pattern's identity
  SymmetricMatrix(int n, const Couplings &couplings);

  int n() const { return static_cast<int>(sparsity_.offsets.size()) - 1; }
  /// Differs between any two patterns ever made: caches of places compare it.
  long pattern_id() const { return pattern_id_; }
  std::size_t n_entries() const { return values_.size(); }
  /// Place of entry (row, column), row <= column, or -1.
  int find(int row, int column) const { return sparsity_.find(row, column); }
  /// Adds to entry (i, j) or (j, i), whichever is stored; throws std::logic_error outside the pattern.
  void add(int i, int j, double value);
  /// A dense symmetric block of some equations in ascending order, which may repeat. Throws as add does.
  void add_block(const std::vector<int> &equations, const Eigen::MatrixXd &block);
  void set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }
  double diagonal(int i) const { return values_[sparsity_.offsets[i]]; }
  Eigen::VectorXd diagonal() const;
  Eigen::VectorXd multiply(const Eigen::VectorXd &x) const;
  /// Row and column of an equation become nil but for `diagonal`; `column` gains `factor` times what was in the column.
  void isolate(int equation, double diagonal, double factor, Eigen::VectorXd &column);

  const std::vector<int> &offsets() const { return sparsity_.offsets; }
  const std::vector<int> &columns() const { return sparsity_.columns; }
  std::vector<double> &values() { return values_; }
  const std::vector<double> &values() const { return values_; }

private:
  /// Rows of one node, mostly: row k + 1 has the columns of row k but for its first. All have the last one's.
  struct Bundle {
    int first, rows;
  };
  template <int rows> void multiply(int first, const double *x, double *y) const;
  Sparsity sparsity_;
  long pattern_id_;
  std::vector<Bundle> bundles_;
  std::vector<double> values_;
};

} // namespace rimpact::fe
