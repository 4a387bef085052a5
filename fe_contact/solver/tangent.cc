#include "fe_contact/solver/tangent.h"

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
