/// Which entries a sparse matrix has, by rows (CSR).
#pragma once
#include <stdexcept>
#include <vector>

namespace rimpact::fe {

/// Each is a list of equations coupled with one another (-1 entries are skipped).
using Couplings = std::vector<std::vector<int>>;

struct Sparsity {
  std::vector<int> offsets; ///< where each row begins, and the number of entries
  std::vector<int> columns; ///< ascending within a row

  static Sparsity whole(int n, const Couplings &couplings);
  /// The upper triangle with all of the diagonal: each row begins with it.
  static Sparsity upper(int n, const Couplings &couplings);
  /// The entry (row, column), or -1.
  int find(int row, int column) const;
  int at(int row, int column) const; ///< likewise; throws std::logic_error where there is none
  /// Calls entry(place, i) for column at[i] of a row, i from `first` on, in one walk along the row. The columns ascend
  /// and may repeat. Throws std::logic_error where one is not in the row.
  template <class Entry> void walk(int row, const std::vector<int> &at, std::size_t first, Entry &&entry) const {
    int k = offsets[row];
    const int end = offsets[row + 1];
    for (std::size_t i = first; i < at.size(); ++i) {
      while (k < end && columns[k] < at[i]) ++k;
      if (k == end || columns[k] != at[i]) throw std::logic_error("matrix entry outside the sparsity pattern");
      entry(k, i);
    }
  }
};

} // namespace rimpact::fe
