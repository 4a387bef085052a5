// Relations between equations: what breaks one costs energy, and its forces and tangent are that energy's.
#include "fe_contact/engine/stiff_ties.h"
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

StiffTies three_relations() {
  StiffTies ties;
  ties.add({{0, 1}, {1, 1}, {2, -2}}, 3e4);
  ties.add({{1, 1}, {-1, 5}, {3, -1}}, 7e3); // one of them is held at zero
  ties.add({{2, 1}, {2, 1}, {0, -6}}, 2e3);  // one stands twice
  return ties;
}

TEST(StiffTies, CostNothingWhereTheyAreKept) {
  const Eigen::Vector4d kept(1, 5, 3, 5);
  EXPECT_EQ(three_relations().energy(kept), 0);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(4);
  three_relations().add_forces(kept, forces);
  EXPECT_EQ(forces.norm(), 0);
}

TEST(StiffTies, ForcesAreTheEnergysSlopeAndTheTangentTheirs) {
  const StiffTies ties = three_relations();
  const Eigen::Vector4d u(0.3, -0.2, 0.7, 0.4);
  for (const Symmetry symmetry : {Symmetry::symmetric, Symmetry::general}) {
    TimeSplit times;
    Tangent tangent(4, {}, ties.couplings(), symmetry, times);
    ties.add_tangent(tangent);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(4);
    ties.add_forces(u, forces);
    const double h = 1e-4;
    for (int i = 0; i < 4; ++i) {
      Eigen::VectorXd up = u, down = u, at_up = Eigen::VectorXd::Zero(4), at_down = at_up;
      up[i] += h, down[i] -= h;
      EXPECT_NEAR(forces[i], (ties.energy(up) - ties.energy(down)) / (2 * h), 1e-6 * forces.norm()) << i;
      ties.add_forces(up, at_up);
      ties.add_forces(down, at_down);
      const Eigen::VectorXd column = tangent.multiply(Eigen::Vector4d::Unit(i));
      EXPECT_LT((column - (at_up - at_down) / (2 * h)).norm(), 1e-6 * column.norm()) << i;
    }
  }
}

} // namespace
} // namespace rimpact::fe
