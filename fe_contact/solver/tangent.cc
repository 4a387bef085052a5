#include "fe_contact/solver/tangent.h"

#include "fe_contact/solver/ranks.h"

namespace rimpact::fe {

Tangent::Tangent(int n, const std::vector<std::vector<int>> &couplings, Symmetry symmetry, TimeSplit &times)
    : symmetric_(n, couplings) {
  if (symmetry == Symmetry::general) general_ = std::make_unique<GeneralMatrix>(symmetric_);
  solver_ =
      general_ ? std::make_unique<LinearSolver>(*general_, times) : std::make_unique<LinearSolver>(symmetric_, times);
}

void Tangent::add(int row, int column, double value) {
  if (general_)
    general_->add(row, column, value);
  else
    symmetric_.add(row, column, row == column ? value : 0.5 * value);
}

void Tangent::add_row(int row, const std::vector<int> &columns, const double *values) {
  if (general_) return general_->add_row(row, columns, values);
  for (std::size_t i = 0; i < columns.size(); ++i) add(row, columns[i], values[i]);
}

Eigen::MatrixXd Tangent::block(const std::vector<int> &equations) const {
  std::vector<int> place(symmetric_.n(), -1);
  for (std::size_t i = 0; i < equations.size(); ++i) place[equations[i]] = static_cast<int>(i);
  const auto &values = general_ ? general_->values() : symmetric_.values();
  const auto &offsets = general_ ? general_->offsets() : symmetric_.offsets();
  const auto &columns = general_ ? general_->columns() : symmetric_.columns();
  const auto n = static_cast<Eigen::Index>(equations.size());
  Eigen::VectorXd entries = Eigen::VectorXd::Zero(n * n);
  Eigen::Map<Eigen::MatrixXd> result(entries.data(), n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (int k = offsets[equations[i]]; k < offsets[equations[i] + 1]; ++k) {
      const int j = place[columns[k]];
      if (j < 0) continue;
      result(i, j) = values[k];
      if (!general_) result(j, i) = values[k];
    }
  ranks().all_reduce_sum(entries);
  return result;
}

void Tangent::drive(int equation, double diagonal, double miss, Eigen::VectorXd &moved) {
  if (general_) return general_->make_unit_row(equation, diagonal);
  auto &values = symmetric_.values();
  const auto &offsets = symmetric_.offsets(), &columns = symmetric_.columns();
  for (int k = offsets[equation]; k < offsets[equation + 1]; ++k) {
    moved[columns[k]] -= values[k] * miss;
    values[k] = 0;
  }
  for (int row = 0; row < equation; ++row)
    if (const int place = symmetric_.find(row, equation); place >= 0) {
      moved[row] -= values[place] * miss;
      values[place] = 0;
    }
  values[offsets[equation]] = diagonal;
}

} // namespace rimpact::fe
