#include "fe_contact/solver/tangent.h"

#include "fe_contact/solver/ranks.h"

namespace rimpact::fe {
namespace {

Couplings together(Couplings first, const Couplings &second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

} // namespace

Tangent::Tangent(int n, const Couplings &solids, const Couplings &contacts, Symmetry symmetry, TimeSplit &times)
    : symmetric_(n, symmetry == Symmetry::general ? solids : together(solids, contacts)) {
  if (symmetry == Symmetry::general) contact_.emplace(n, contacts);
  solver_ = std::make_unique<LinearSolver>(symmetric_, contact_ ? &*contact_ : nullptr, times);
}

void Tangent::set_zero() {
  symmetric_.set_zero();
  if (contact_) contact_->set_zero();
}

void Tangent::add(int row, int column, double value) {
  if (contact_)
    contact_->add(row, column, value);
  else
    symmetric_.add(row, column, row == column ? value : 0.5 * value);
}

void Tangent::add_block(const std::vector<int> &equations, const Eigen::MatrixXd &block) {
  if (contact_)
    contact_->add_block(equations, block);
  else
    symmetric_.add_block(equations, 0.5 * (block + block.transpose()));
}

Eigen::VectorXd Tangent::multiply(const Eigen::VectorXd &x) const {
  Eigen::VectorXd result = symmetric_.multiply(x);
  if (contact_) contact_->add_product(x, result);
  return result;
}

Eigen::MatrixXd Tangent::block(const std::vector<int> &equations) const {
  std::vector<int> place(symmetric_.n(), -1);
  for (std::size_t i = 0; i < equations.size(); ++i) place[equations[i]] = static_cast<int>(i);
  const auto n = static_cast<Eigen::Index>(equations.size());
  Eigen::VectorXd entries = Eigen::VectorXd::Zero(n * n);
  Eigen::Map<Eigen::MatrixXd> result(entries.data(), n, n);
  const auto add = [&](const auto &matrix, bool both) {
    for (Eigen::Index i = 0; i < n; ++i)
      for (int k = matrix.offsets()[equations[i]]; k < matrix.offsets()[equations[i] + 1]; ++k) {
        const int j = place[matrix.columns()[k]];
        if (j < 0) continue;
        result(i, j) += matrix.values()[k];
        if (both && j != i) result(j, i) += matrix.values()[k];
      }
  };
  add(symmetric_, true);
  if (contact_) add(*contact_, false);
  ranks().all_reduce_sum(entries);
  return result;
}

void Tangent::drive(int equation, double diagonal, double miss, Eigen::VectorXd &moved) {
  symmetric_.isolate(equation, diagonal, -miss, moved);
  if (contact_) contact_->clear_row(equation);
}

} // namespace rimpact::fe
