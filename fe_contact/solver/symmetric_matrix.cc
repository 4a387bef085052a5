#include "fe_contact/solver/symmetric_matrix.h"

#include <array>
#include <atomic>

namespace rimpact::fe {

SymmetricMatrix::SymmetricMatrix(int n, const Couplings &couplings) : sparsity_(Sparsity::upper(n, couplings)) {
  static std::atomic<long> patterns{0};
  pattern_id_ = ++patterns;
  values_.assign(columns().size(), 0.0);
  const auto follows = [&](int row) { // its columns are those of the row before but for the first
    const auto before = columns().begin() + offsets()[row - 1] + 1, own = columns().begin() + offsets()[row];
    return std::equal(before, own, own, columns().begin() + offsets()[row + 1]);
  };
  constexpr int most_rows = 3;
  for (int row = 0; row < n; ++row)
    if (row > 0 && bundles_.back().rows < most_rows && follows(row))
      ++bundles_.back().rows;
    else
      bundles_.push_back({row, 1});
}

Eigen::VectorXd SymmetricMatrix::diagonal() const {
  Eigen::VectorXd result(n());
  for (int i = 0; i < n(); ++i) result[i] = diagonal(i);
  return result;
}

void SymmetricMatrix::add(int i, int j, double value) {
  values_[sparsity_.at(std::min(i, j), std::max(i, j))] += value;
}

void SymmetricMatrix::add_block(const std::vector<int> &equations, const Eigen::MatrixXd &block) {
  for (std::size_t i = 0; i < equations.size(); ++i)
    sparsity_.walk(equations[i], equations, i, [&](int place, std::size_t j) {
      const double twice = j != i && equations[j] == equations[i] ? 2.0 : 1.0; // both triangles, on the diagonal
      values_[place] += twice * block(i, j);
    });
}

/// One walk along the columns that the rows have in common, for both triangles at once.
template <int rows> void SymmetricMatrix::multiply(int first, const double *x, double *y) const {
  std::array<const double *, rows> value;
  std::array<double, rows> sum{}, own;
  for (int r = 0; r < rows; ++r) {
    value[r] = values_.data() + offsets()[first + r];
    own[r] = x[first + r];
    sum[r] += *value[r]++ * own[r];
    for (int c = r + 1; c < rows; ++c) {
      const double entry = *value[r]++;
      sum[r] += entry * x[first + c];
      sum[c] += entry * own[r];
    }
  }
  const int *column = columns().data() + offsets()[first + rows - 1] + 1;
  const int n = offsets()[first + rows] - offsets()[first + rows - 1] - 1;
  for (int k = 0; k < n; ++k) {
    const double at = x[column[k]];
    double transposed = 0;
    for (int r = 0; r < rows; ++r) {
      const double entry = value[r][k];
      sum[r] += entry * at;
      transposed += entry * own[r];
    }
    y[column[k]] += transposed;
  }
  for (int r = 0; r < rows; ++r) y[first + r] += sum[r];
}

Eigen::VectorXd SymmetricMatrix::multiply(const Eigen::VectorXd &x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n());
  for (const auto [first, rows] : bundles_)
    if (rows == 3)
      multiply<3>(first, x.data(), y.data());
    else if (rows == 2)
      multiply<2>(first, x.data(), y.data());
    else
      multiply<1>(first, x.data(), y.data());
  return y;
}

void SymmetricMatrix::isolate(int equation, double diagonal, double factor, Eigen::VectorXd &column) {
  for (int k = offsets()[equation]; k < offsets()[equation + 1]; ++k) {
    column[columns()[k]] += factor * values_[k];
    values_[k] = 0;
  }
  for (int row = 0; row < equation; ++row)
    if (const int place = find(row, equation); place >= 0) {
      column[row] += factor * values_[place];
      values_[place] = 0;
    }
  values_[offsets()[equation]] = diagonal;
}

} // namespace rimpact::fe
