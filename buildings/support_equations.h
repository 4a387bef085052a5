/// The equations of the closed bearings' normal forces N together (dynamics.h): with the accelerations that the sliders
/// would have away from their dishes without them, sum_c E_bc N_c = rest_b.
///
/// A bearing moves its own node up by itself, and all nodes of its diaphragm by that one's three motions:
///   E_bc = own_b (b = c) + a_b . b_c within a diaphragm,
/// so that the solution takes three sums a diaphragm: a cost that grows with the number of bearings, not with its cube.
/// SI units.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace rimpact::buildings {

struct SupportRow {
  int diaphragm;
  double own;               ///< away from the dish by the node's own vertical motion, per N [1/kg], > 0
  Eigen::Vector3d response; ///< a_b: away from the dish by the diaphragm's (x, y, turn) accelerations over its masses
  Eigen::Vector3d push;     ///< b_b: force and moment on the diaphragm per N
  double rest;              ///< acceleration towards the dish without any N [m/s^2]
};

class SupportEquations {
public:
  explicit SupportEquations(int n_diaphragms) : n_diaphragms_(n_diaphragms) {}
  void add(const SupportRow &row) { rows_.push_back(row); }
  /// N of each row [N].
  Eigen::VectorXd solve() const;
  /// The N >= 0 that drive no slider through its dish, the smaller of N and opening zero; to `accuracy` [N].
  Eigen::VectorXd solve_without_pull(double accuracy) const;

private:
  int n_diaphragms_;
  std::vector<SupportRow> rows_;
};

} // namespace rimpact::buildings
