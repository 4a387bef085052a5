/// Linear relations that the equations' values keep, each by a spring so stiff that it gives way by less than contacts
/// do: sum of factor * value = 0.
#pragma once
#include "fe_contact/solver/tangent.h"
#include <Eigen/Core>
#include <vector>

namespace rimpact::fe {

class StiffTies {
public:
  struct Term {
    int equation; ///< -1: held at zero
    double factor;
  };
  /// stiffness > 0 [N/m]
  void add(std::vector<Term> terms, double stiffness) { ties_.push_back({std::move(terms), stiffness}); }
  /// The equations of each relation, for a pattern.
  Couplings couplings() const;
  void add_forces(const Eigen::VectorXd &u, Eigen::VectorXd &forces) const; ///< internal sign, at the values u [m]
  void add_tangent(Tangent &tangent) const;
  double energy(const Eigen::VectorXd &u) const; ///< that the springs store [J]

private:
  struct Tie {
    std::vector<Term> terms;
    double stiffness;
    double miss(const Eigen::VectorXd &u) const; ///< of the relation [m]
  };
  std::vector<Tie> ties_;
};

} // namespace rimpact::fe
