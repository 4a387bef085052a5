/// What both cases of shallow ironing share: a die is driven down and across a slab, and what it feels is kept.
#pragma once
#include "setups.h"

namespace rimpact::verification {

struct Ironing {
  /// The die moves by two equations; its contact with the slab is the system's first.
  Ironing(ContactSystem &system, int x_equation, int z_equation);
  /// The die goes from one place to another, in at least so many steps of alike length.
  fe::MarchReport move(const Vector3d &from, const Vector3d &to, int pieces);
  void turn(); ///< the next way is another: forces are kept anew, and the last change is no guess
  std::string last_residuals() const;

  SystemState state;
  std::vector<double> vertical, along; ///< forces on the slab's side by step [N]
  int steps = 0, cuts = 0, iterations = 0;
  int most_a_step = 0, most_a_solution = 0; ///< iterations

private:
  ContactSystem &system_;
  int x_equation_, z_equation_;
  fe::StepOptions options_;
  Eigen::VectorXd change_;
  std::vector<double> residuals_;
};

} // namespace rimpact::verification
