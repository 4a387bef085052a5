#include "fe_contact/solver/sparsity.h"

#include <algorithm>

namespace rimpact::fe {
namespace {

void sort_out(std::vector<int> &values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Each coupling goes to the rows of its equations, of the upper triangle alone or whole.
Sparsity of(std::vector<std::vector<int>> rows, const Couplings &couplings, bool upper) {
  std::vector<int> sorted;
  for (const auto &coupling : couplings) {
    sorted = coupling;
    std::erase_if(sorted, [](int equation) { return equation < 0; });
    sort_out(sorted);
    for (auto at = sorted.begin(); at != sorted.end(); ++at)
      rows[*at].insert(rows[*at].end(), upper ? at : sorted.begin(), sorted.end());
  }
  Sparsity result{{0}, {}};
  for (auto &row : rows) {
    sort_out(row);
    result.columns.insert(result.columns.end(), row.begin(), row.end());
    result.offsets.push_back(static_cast<int>(result.columns.size()));
    std::vector<int>().swap(row);
  }
  return result;
}

} // namespace

Sparsity Sparsity::whole(int n, const Couplings &couplings) {
  return of(std::vector<std::vector<int>>(n), couplings, false);
}

Sparsity Sparsity::upper(int n, const Couplings &couplings) {
  std::vector<std::vector<int>> rows(n);
  for (int i = 0; i < n; ++i) rows[i].push_back(i);
  return of(std::move(rows), couplings, true);
}

int Sparsity::find(int row, int column) const {
  const auto begin = columns.begin() + offsets[row], end = columns.begin() + offsets[row + 1];
  const auto found = std::lower_bound(begin, end, column);
  return found != end && *found == column ? static_cast<int>(found - columns.begin()) : -1;
}

int Sparsity::at(int row, int column) const {
  const int place = find(row, column);
  if (place < 0) throw std::logic_error("matrix entry outside the sparsity pattern");
  return place;
}

} // namespace rimpact::fe
