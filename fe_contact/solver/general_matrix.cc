#include "fe_contact/solver/general_matrix.h"

#include <algorithm>
#include <stdexcept>

namespace rimpact::fe {

GeneralMatrix::GeneralMatrix(const SymmetricMatrix &pattern) {
  const int n = pattern.n();
  const auto &offsets = pattern.offsets(), &columns = pattern.columns();
  std::vector<int> count(n, 0);
  for (int i = 0; i < n; ++i)
    for (int k = offsets[i]; k < offsets[i + 1]; ++k) {
      ++count[i];
      if (columns[k] != i) ++count[columns[k]];
    }
  offsets_.assign(n + 1, 0);
  for (int i = 0; i < n; ++i) offsets_[i + 1] = offsets_[i] + count[i];
  columns_.resize(offsets_[n]);
  values_.assign(offsets_[n], 0.0);
  from_.resize(offsets_[n]);
  diagonals_.assign(offsets_.begin(), offsets_.end() - 1);
  // Row by row, the lower entries of a row come from the rows above it, so columns come out sorted.
  std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
  for (int i = 0; i < n; ++i)
    for (int k = offsets[i]; k < offsets[i + 1]; ++k) {
      const int j = columns[k], upper = next[i]++;
      columns_[upper] = j, from_[upper] = k;
      if (j == i) {
        diagonals_[i] = upper;
        continue;
      }
      const int lower = next[j]++;
      columns_[lower] = i, from_[lower] = k;
    }
}

void GeneralMatrix::assign(const SymmetricMatrix &symmetric) {
  const auto &values = symmetric.values();
  for (int row = 0; row < n(); ++row)
    if (symmetric.diagonal(row) == 0) // of a rank that has no cell there
      std::fill(values_.begin() + offsets_[row], values_.begin() + offsets_[row + 1], 0.0);
    else
      for (int k = offsets_[row]; k < offsets_[row + 1]; ++k) values_[k] = values[from_[k]];
}

int GeneralMatrix::entry_of(int row, int column) const {
  const auto begin = columns_.begin() + offsets_[row], end = columns_.begin() + offsets_[row + 1];
  const auto found = std::lower_bound(begin, end, column);
  if (found == end || *found != column) throw std::logic_error("matrix entry outside the sparsity pattern");
  return static_cast<int>(found - columns_.begin());
}

void GeneralMatrix::add(int row, int column, double value) {
  values_[entry_of(row, column)] += value;
}

void GeneralMatrix::add_row(int row, const std::vector<int> &columns, const double *values) {
  int k = offsets_[row];
  const int end = offsets_[row + 1];
  for (std::size_t i = 0; i < columns.size(); ++i) {
    while (k < end && columns_[k] < columns[i]) ++k;
    if (k == end || columns_[k] != columns[i]) throw std::logic_error("matrix entry outside the sparsity pattern");
    values_[k] += values[i];
  }
}

void GeneralMatrix::make_unit_row(int row, double diagonal) {
  std::fill(values_.begin() + offsets_[row], values_.begin() + offsets_[row + 1], 0.0);
  values_[diagonals_[row]] = diagonal;
}

Eigen::VectorXd GeneralMatrix::multiply(const Eigen::VectorXd &x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n());
  for (int i = 0; i < n(); ++i)
    for (int k = offsets_[i]; k < offsets_[i + 1]; ++k) y[i] += values_[k] * x[columns_[k]];
  return y;
}

} // namespace rimpact::fe
