#include "fe_contact/solver/general_matrix.h"

#include <algorithm>

namespace rimpact::fe {

GeneralMatrix::GeneralMatrix(int n, const Couplings &couplings)
    : sparsity_(Sparsity::whole(n, couplings)), filled_(n, 0), values_(sparsity_.columns.size(), 0.0) {
  for (int row = 0; row < n; ++row) diagonals_.push_back(sparsity_.find(row, row));
}

void GeneralMatrix::set_zero() {
  for (int row = 0; row < n(); ++row)
    if (filled_[row]) clear_row(row);
}

void GeneralMatrix::add(int row, int column, double value) {
  values_[sparsity_.at(row, column)] += value;
  filled_[row] = 1;
}

void GeneralMatrix::add_block(const std::vector<int> &equations, const Eigen::MatrixXd &block) {
  for (std::size_t i = 0; i < equations.size(); ++i) {
    sparsity_.walk(equations[i], equations, 0, [&](int place, std::size_t j) { values_[place] += block(i, j); });
    filled_[equations[i]] = 1;
  }
}

void GeneralMatrix::clear_row(int row) {
  std::fill(values_.begin() + offsets()[row], values_.begin() + offsets()[row + 1], 0.0);
  filled_[row] = 0;
}

void GeneralMatrix::add_product(const Eigen::VectorXd &x, Eigen::VectorXd &y) const {
  for (int row = 0; row < n(); ++row) {
    if (!filled_[row]) continue;
    double sum = 0;
    for (int k = offsets()[row]; k < offsets()[row + 1]; ++k) sum += values_[k] * x[columns()[k]];
    y[row] += sum;
  }
}

} // namespace rimpact::fe
