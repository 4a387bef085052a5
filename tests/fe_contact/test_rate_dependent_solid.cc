// Solids whose steel knows its rate: the tangent of a mesh, an impact with its ledger.
#include "blocks.h"
#include "fe_contact/engine/solid_fields.h"

#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using scene::RateModel;

TEST(RateDependentSolid, TangentOfAMeshAgreesWithDifferences) {
  for (const RateModel model : {RateModel::cowper_symonds, RateModel::johnson_cook})
    for (const double dt : {1e-7, 1e-3}) {
      Bar bar({.model = model});
      const Equations &equations = bar.system->equations();
      std::mt19937 generator(1);
      std::normal_distribution<double> normal(0, 1e-5);
      Eigen::VectorXd u(bar.space.n_dofs()), direction = Eigen::VectorXd::Zero(u.size());
      for (auto &value : u) value = normal(generator);
      for (int dof = 0; dof < u.size(); ++dof)
        if (equations.of_dof[dof] >= 0) direction[dof] = normal(generator);
      SymmetricMatrix tangent(equations.n, bar.solid.couplings(equations));
      const SolidHistory initial_history = bar.solid.initial_history();
      SolidHistory next;
      SolidEnergies energies;
      Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n), plus = forces, minus = forces;
      ASSERT_TRUE(bar.solid.assemble(u, initial_history, next, equations, forces, &tangent, energies, dt));
      EXPECT_GT(energies.plastic, 0);
      const double h = 1e-4;
      ASSERT_TRUE(bar.solid.assemble(u + h * direction, initial_history, next, equations, plus, nullptr, energies, dt));
      ASSERT_TRUE(
          bar.solid.assemble(u - h * direction, initial_history, next, equations, minus, nullptr, energies, dt));
      const Eigen::VectorXd difference = (plus - minus) / (2 * h),
                            exact = tangent.multiply(equations.gather(direction));
      EXPECT_LT((difference - exact).norm(), 1e-5 * exact.norm()) << dt;
    }
}

TEST(RateDependentSolid, FieldsShowTheStressThatTheRateBears) {
  Bar bar({.model = RateModel::cowper_symonds});
  const Equations &equations = bar.system->equations();
  constexpr double stretch = 0.01; // along x, held across
  Eigen::VectorXd u = Eigen::VectorXd::Zero(bar.space.n_dofs()), forces = Eigen::VectorXd::Zero(equations.n);
  for (std::size_t a = 0; a < bar.space.n_nodes; ++a) u[3 * a] = stretch * bar.space.positions[a].x();
  SolidHistory next;
  SolidEnergies energies;
  ASSERT_TRUE(bar.solid.assemble(u, bar.solid.initial_history(), next, equations, forces, nullptr, energies, 1e-4));
  const SolidFields fields = fields_of(bar.solid, bar.space, u, next);
  const J2State &point = next.front();
  const double flow = bar.solid.law_of(0).isochoric.hardening.stress(point.alpha);
  EXPECT_GT(point.overstress, 0.1 * flow);
  for (const double von_mises : fields.von_mises)
    EXPECT_NEAR(von_mises * (1 + stretch) / (flow + point.overstress), 1, 1e-9);
}

struct BarImpact {
  EnergyLedger ledger;
  int steps;
  double strain = 0, viscous_work = 0; ///< the largest of a point [-, J/m^3]
};

BarImpact bar_impact(const scene::StrainRate &rate) {
  Bar bar(rate);
  SystemState state = bar.thrown();
  const MotionReport report = bar.run(state, 14e-6);
  EXPECT_TRUE(report.march.finished) << report.march.reason;
  BarImpact result{report.ledger, report.march.steps};
  for (const auto &point : state.history) {
    result.strain = std::max(result.strain, point.alpha);
    result.viscous_work = std::max(result.viscous_work, point.viscous_work);
  }
  return result;
}

TEST(RateDependentSolid, AnImpactKeepsItsLedgerAndStrainsLess) {
  const BarImpact none = bar_impact({});
  EXPECT_EQ(none.viscous_work, 0);
  for (const RateModel model : {RateModel::cowper_symonds, RateModel::johnson_cook}) {
    const BarImpact fast = bar_impact({.model = model});
    EXPECT_GT(fast.viscous_work, 0);
    EXPECT_LT(std::abs(fast.ledger.imbalance_relative()), std::abs(none.ledger.imbalance_relative()) + 1e-3);
    EXPECT_LT(fast.strain, none.strain);
  }
}

TEST(RateDependentSolid, ARateThatIsNeverNearMakesNoDifference) {
  const auto none = bar_impact({}), far = bar_impact({.model = RateModel::johnson_cook, .reference = 1e9});
  EXPECT_NEAR(far.ledger.plastic, none.ledger.plastic, 1e-9 * none.ledger.plastic);
  EXPECT_NEAR(far.ledger.friction, none.ledger.friction, 1e-9 * none.ledger.plastic);
  EXPECT_EQ(far.steps, none.steps);
}

} // namespace
} // namespace rimpact::fe
