#include "fe_contact/solver/symmetric_matrix.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace rimpact::fe {

SymmetricMatrix::SymmetricMatrix(int n, const std::vector<std::vector<int>> &couplings) : n_(n) {
  static std::atomic<long> patterns{0};
  pattern_id_ = ++patterns;
  std::vector<std::vector<int>> rows(n);
  for (int i = 0; i < n; ++i) rows[i].push_back(i);
  std::vector<int> sorted;
  for (const auto &clique : couplings) {
    sorted.clear();
    for (const int equation : clique)
      if (equation >= 0) sorted.push_back(equation);
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    for (std::size_t a = 0; a < sorted.size(); ++a)
      rows[sorted[a]].insert(rows[sorted[a]].end(), sorted.begin() + a, sorted.end());
  }
  offsets_.push_back(0);
  for (auto &row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    columns_.insert(columns_.end(), row.begin(), row.end());
    offsets_.push_back(columns_.size());
    std::vector<int>().swap(row);
  }
  values_.assign(columns_.size(), 0.0);
}

int SymmetricMatrix::find(int row, int column) const {
  const auto begin = columns_.begin() + offsets_[row], end = columns_.begin() + offsets_[row + 1];
  const auto found = std::lower_bound(begin, end, column);
  return found != end && *found == column ? static_cast<int>(found - columns_.begin()) : -1;
}

void SymmetricMatrix::add(int i, int j, double value) {
  const int place = find(std::min(i, j), std::max(i, j));
  if (place < 0) throw std::logic_error("matrix entry outside the sparsity pattern");
  values_[place] += value;
}

Eigen::VectorXd SymmetricMatrix::multiply(const Eigen::VectorXd &x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n_);
  for (int i = 0; i < n_; ++i) {
    double sum = values_[offsets_[i]] * x[i];
    for (int k = offsets_[i] + 1; k < offsets_[i + 1]; ++k) {
      sum += values_[k] * x[columns_[k]];
      y[columns_[k]] += values_[k] * x[i];
    }
    y[i] += sum;
  }
  return y;
}

void SymmetricMatrix::make_unit_row(int i, double diagonal) {
  for (int k = offsets_[i]; k < offsets_[i + 1]; ++k) values_[k] = 0.0;
  values_[offsets_[i]] = diagonal;
}

} // namespace rimpact::fe
