#include "fe_contact/engine/stiff_ties.h"

#include <cmath>

namespace rimpact::fe {

Couplings StiffTies::couplings() const {
  Couplings result;
  for (const Tie &tie : ties_) {
    result.emplace_back();
    for (const Term &term : tie.terms) result.back().push_back(term.equation);
  }
  return result;
}

double StiffTies::Tie::miss(const Eigen::VectorXd &u) const {
  double sum = 0;
  for (const auto &[equation, factor] : terms)
    if (equation >= 0) sum += factor * u[equation];
  return sum;
}

double StiffTies::energy(const Eigen::VectorXd &u) const {
  double sum = 0;
  for (const Tie &tie : ties_) sum += 0.5 * tie.stiffness * std::pow(tie.miss(u), 2);
  return sum;
}

void StiffTies::add_forces(const Eigen::VectorXd &u, Eigen::VectorXd &forces) const {
  for (const Tie &tie : ties_) {
    const double force = tie.stiffness * tie.miss(u);
    for (const auto &[equation, factor] : tie.terms)
      if (equation >= 0) forces[equation] += factor * force;
  }
}

void StiffTies::add_tangent(Tangent &tangent) const {
  for (const auto &[terms, stiffness] : ties_)
    for (const auto &[row, factor] : terms)
      for (const auto &[column, other] : terms)
        if (row >= 0 && column >= 0) tangent.add(row, column, stiffness * factor * other);
}

} // namespace rimpact::fe
