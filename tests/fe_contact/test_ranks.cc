// Several ranks compute what one does. Run under mpirun; each rank also solves every problem on its own.
#include "blocks.h"
#include "fe_contact/solver/ranks.h"

#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

/// Of everything a state holds, relative to its size.
void expect_close(const SystemState &alone, const SystemState &shared, double bound) {
  const auto relative = [](const auto &a, const auto &b) { return (a - b).norm() / std::max(1e-300, a.norm()); };
  EXPECT_LT(relative(alone.u, shared.u), bound);
  EXPECT_LT((alone.R - shared.R).norm(), bound * (alone.R.norm() + alone.reports[0].force.norm()));
  EXPECT_LT(relative(alone.reports[0].force, shared.reports[0].force), bound);
  EXPECT_LT(relative(alone.reports[0].friction, shared.reports[0].friction), bound);
  EXPECT_EQ(alone.contacts[0].status, shared.contacts[0].status);
  EXPECT_EQ(alone.contacts[0].opposite, shared.contacts[0].opposite);
  EXPECT_EQ(alone.reports[0].slip, shared.reports[0].slip);
  EXPECT_EQ(alone.reports[0].stick, shared.reports[0].stick);
  EXPECT_NEAR(alone.energies.elastic, shared.energies.elastic, bound * alone.energies.elastic);
  EXPECT_NEAR(alone.energies.plastic, shared.energies.plastic, bound * alone.energies.elastic);
  double strain = 0;
  for (std::size_t k = 0; k < alone.history.size(); ++k)
    strain = std::max(strain, std::abs(alone.history[k].alpha - shared.history[k].alpha));
  EXPECT_LT(strain, bound);
}

template <class Solve> auto on_one_rank(const Solve &solve) {
  const OnOneRank alone;
  return solve();
}

SystemState dragged(const FrictionCoefficient &friction) {
  Block block(friction);
  SystemState state = block.system->at_rest();
  StepOptions options;
  options.newton.tolerance = 1e-10;
  for (int k = 1; k <= 8; ++k)
    EXPECT_TRUE(static_step(*block.system, state, block.drive(6e-6 * k, 1e-4, 1e-3), options).converged) << k;
  return state;
}

TEST(Ranks, ThereAreSeveral) {
  EXPECT_GT(ranks().size, 1) << "run by mpirun";
}

/// Every so many springs of a chain are a rank's own.
SymmetricMatrix own_springs(int n, double diagonal) {
  Couplings own;
  for (int i = ranks().own; i + 1 < n; i += ranks().size) own.push_back({i, i + 1});
  SymmetricMatrix result(n, own);
  for (const auto &ends : own) {
    for (const int end : ends) result.add(end, end, diagonal);
    result.add(ends[0], ends[1], -1.0);
  }
  return result;
}

/// Each rank has springs of its own between neighbours, and all of a contact but for what it divides among them.
TEST(Ranks, SolveTheSumOfTheirMatrices) {
  constexpr int n = 60;
  Couplings neighbours;
  for (int i = 0; i + 1 < n; ++i) neighbours.push_back({i, i + 1});
  const SymmetricMatrix springs = own_springs(n, 2);
  GeneralMatrix contact(n, neighbours);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n, n);
  const double share = 1.0 / ranks().size;
  for (int i = 0; i + 1 < n; ++i) {
    contact.add(i, i + 1, 0.4 * share);
    whole.block<2, 2>(i, i) += (Eigen::Matrix2d() << 2, -0.6, -1, 2).finished();
  }
  TimeSplit times;
  LinearSolver solver(springs, &contact, times);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2), x = solver.solve_anew(b, 1e-12, 30);
  ASSERT_EQ(x.size(), n);
  EXPECT_LT((whole * x - b).norm(), 1e-11 * b.norm());
  EXPECT_LE(solver.last_iterations(), 4); // the factor is of the sum, too
}

TEST(Ranks, StickAndSlipAreThoseOfOneRank) {
  const auto rough = [] { return dragged(FrictionCoefficient{0.3, 0.2, 50}); };
  const SystemState alone = on_one_rank(rough);
  EXPECT_GT(alone.reports[0].slip, 0);
  expect_close(alone, rough(), 1e-8);
}

TEST(Ranks, ASmoothContactIsThatOfOneRank) {
  const auto smooth = [] { return dragged(FrictionCoefficient{}); };
  const SystemState alone = on_one_rank(smooth);
  EXPECT_GT(alone.reports[0].force.z(), 1e3);
  expect_close(alone, smooth(), 1e-8);
}

/// Springs between neighbours, shared out; with nil on the diagonal no pivots are there, and the factor is made in
/// double precision.
void solve_springs(double diagonal) {
  constexpr int n = 60;
  const SymmetricMatrix springs = own_springs(n, diagonal);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i + 1 < n; ++i)
    whole.block<2, 2>(i, i) += (Eigen::Matrix2d() << diagonal, -1, -1, diagonal).finished();
  TimeSplit times;
  LinearSolver solver(springs, nullptr, times);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2), x = solver.solve_anew(b, 1e-12, 30);
  ASSERT_EQ(x.size(), n) << diagonal;
  EXPECT_LT((whole * x - b).norm(), 1e-10 * b.norm());
}

TEST(Ranks, SolveTheSumOfTheirSymmetricMatrices) {
  for (const double diagonal : {2.0, 0.0}) solve_springs(diagonal);
}

/// Ten steps of one deformable block over another, whose faces do not match.
SystemState slid() {
  const Discretisation space(TwoBlocks::mesh(), 2);
  const Solid solid(space, TwoBlocks::materials());
  Supports supports(space);
  int top[3];
  for (int i = 0; i < 3; ++i) {
    top[i] = supports.tie(i, [](const Vector3d &x) { return x.z() > 0.09; });
    supports.fix(i, [](const Vector3d &x) { return x.z() < -0.09; });
  }
  ContactSystem system(space, solid, supports.number());
  system.add_contact(Surface::slider_side, TwoBlocks::master(), TwoBlocks::options());
  SystemState state = system.at_rest();
  StepOptions options;
  options.newton.tolerance = 1e-10;
  for (int k = 1; k <= 10; ++k) {
    StepTerms terms{Eigen::VectorXd::Zero(system.equations().n)};
    terms.driven = {{top[0], 8e-3 * k}, {top[1], 2e-3 * k}, {top[2], -2e-4}};
    const auto step = static_step(system, state, terms, options);
    EXPECT_TRUE(step.converged) << k << ": " << step.reason;
    if (k == 5) system.start_afresh_at(state); // another pattern, another solver
  }
  return state;
}

TEST(Ranks, SlidingOverADeformableMasterIsThatOfOneRank) {
  const SystemState alone = on_one_rank(slid);
  EXPECT_GT(alone.reports[0].slip, 0);
  expect_close(alone, slid(), 1e-8);
}

std::pair<SystemState, MotionReport> impact_of(const scene::StrainRate &rate) {
  Bar bar(rate);
  bar.options.step.newton.tolerance = 1e-10;
  SystemState state = bar.thrown();
  const MotionReport report = bar.run(state, 14e-6);
  EXPECT_TRUE(report.march.finished) << report.march.reason;
  return {state, report};
}

void expect_an_impact_as_on_one_rank(const scene::StrainRate &rate) {
  const auto [alone, alone_report] = on_one_rank([&] { return impact_of(rate); });
  const auto [shared, shared_report] = impact_of(rate);
  EXPECT_GT(alone.energies.plastic, 0);
  expect_close(alone, shared, 1e-8);
  EXPECT_EQ(alone_report.march.steps, shared_report.march.steps);
  EXPECT_NEAR(alone_report.ledger.friction, shared_report.ledger.friction, 1e-8 * alone_report.ledger.largest_input);
  EXPECT_NEAR(alone_report.ledger.integrator, shared_report.ledger.integrator,
              1e-8 * alone_report.ledger.largest_input);
}

TEST(Ranks, AnImpactWithPlasticFlowAndItsLedgerAreThoseOfOneRank) {
  expect_an_impact_as_on_one_rank({});
}

TEST(Ranks, AnImpactOfSteelThatKnowsItsRateIsThatOfOneRank) {
  expect_an_impact_as_on_one_rank({.model = scene::RateModel::cowper_symonds});
}

/// One equation in the middle moved by ten times the strain at yield, and solved by itself with its neighbours.
Eigen::VectorXd eliminated() {
  Bar bar;
  const SystemState state = bar.system->at_rest();
  const StepTerms terms{Eigen::VectorXd::Zero(bar.system->equations().n)};
  bar.system->prepare(state, terms);
  Eigen::VectorXd u = state.u;
  u[u.size() / 2] += 7e-5;
  EXPECT_TRUE(bar.system->evaluate(u, true));
  const double before = bar.system->residual().norm();
  EXPECT_TRUE(bar.system->eliminate(u));
  EXPECT_TRUE(bar.system->evaluate(u, true));
  EXPECT_LT(bar.system->residual().norm(), 0.5 * before); // the neighbours have got some
  return u;
}

TEST(Ranks, AFewEquationsAreSolvedByThemselvesAsOnOneRank) {
  const Eigen::VectorXd alone = on_one_rank(eliminated), shared = eliminated();
  EXPECT_LT((alone - shared).norm(), 1e-10 * alone.norm());
}

TEST(Ranks, ABodyTurnedInsideOutOnOneRankIsSeenByAll) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  const StepTerms terms = block.drive(0, 1e-4, 1e-3);
  block.system->prepare(state, terms);
  Eigen::VectorXd u = state.u;
  for (std::size_t node = 0; node < block.space.n_nodes; ++node) // its last nodes only: the last rank's cells
    if (const int equation = block.system->equations().of_dof[3 * node];
        equation >= 0 && block.space.positions[node].x() > 0.19)
      u[equation] = -0.5;
  EXPECT_FALSE(block.system->evaluate(u, true));
}

} // namespace
} // namespace rimpact::fe
