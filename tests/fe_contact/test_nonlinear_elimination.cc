// A few equations solved by themselves, and cells that answer again as they did.
#include "box_mesh.h"
#include "fe_contact/engine/nonlinear_elimination.h"
#include "fe_contact/solver/newton.h"

#include <gtest/gtest.h>
#include <random>

namespace rimpact::fe {
namespace {

using meshes::Volume;

/// A bar of twenty cells of the bearing's steel along x, free but for its ends, strained beyond its yield in x.
struct Bar {
  Bar() {
    equations.of_dof.assign(space.n_dofs(), -1);
    equations.weight.assign(space.n_dofs(), 1.0);
    for (std::size_t a = 0; a < space.n_nodes; ++a) {
      const double x = space.positions[a].x();
      stretched[3 * a] = 0.01 * x;
      for (int i = 0; i < 3; ++i) stretched[3 * a + i] += normal(generator);
      if (x > 1e-9 && x < 1 - 1e-9)
        for (int i = 0; i < 3; ++i) equations.of_dof[3 * a + i] = equations.n++;
    }
    stretched = equations.expand(equations.gather(stretched));
    forces_there = forces(equations.gather(stretched), nullptr);
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(result, {{0, 0, 0}, {1, 0.1, 0.1}, {20, 1, 1}, Volume::rim, {}});
    return result;
  }
  /// Of the solid and of springs, the same on every equation, which no cell has.
  Eigen::VectorXd forces(const Eigen::VectorXd &u, Tangent *tangent, CellAnswers *answers = nullptr) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(equations.n);
    SymmetricMatrix *symmetric = tangent ? &tangent->symmetric() : nullptr;
    if (tangent) tangent->set_zero();
    EXPECT_TRUE(solid.assemble(equations.expand(u), history, next, equations, result, symmetric, energies, 0, answers));
    for (int i = 0; tangent && i < equations.n; ++i) tangent->add(i, i, spring);
    return result + spring * u;
  }
  Couplings each_by_itself() const { // as the springs do
    Couplings result;
    for (int i = 0; i < equations.n; ++i) result.push_back({i});
    return result;
  }
  Eigen::VectorXd residual(const Eigen::VectorXd &u, Tangent *tangent) { return forces(u, tangent) - forces_there; }

  std::mt19937 generator{1};
  std::normal_distribution<double> normal{0, 2e-5};
  Discretisation space{mesh(), 2};
  Solid solid{space, scene::Bearing{}};
  Equations equations;
  SolidHistory history = solid.initial_history(), next;
  SolidEnergies energies;
  static constexpr double spring = 1e9;
  Eigen::VectorXd stretched = Eigen::VectorXd::Zero(space.n_dofs()), forces_there;
};

/// The node in the middle moved by seven times the strain at yield of its cells.
Eigen::VectorXd disturbed(const Bar &bar, int &equation) {
  Eigen::VectorXd u = bar.equations.gather(bar.stretched);
  for (std::size_t a = 0; a < bar.space.n_nodes; ++a)
    if ((bar.space.positions[a] - Eigen::Vector3d(0.5, 0.05, 0.05)).norm() < 1e-6)
      equation = bar.equations.of_dof[3 * a];
  u[equation] += 5e-4;
  return u;
}

class Elimination : public ::testing::TestWithParam<Symmetry> {};

TEST_P(Elimination, SolvesWhatOneNodeKeepsFromBalanceAndMovesNothingElse) {
  Bar bar;
  int equation = -1;
  Eigen::VectorXd u = disturbed(bar, equation);
  const Eigen::VectorXd solution = bar.equations.gather(bar.stretched), start = u;
  TimeSplit times;
  Tangent tangent(bar.equations.n, bar.solid.couplings(bar.equations), bar.each_by_itself(), GetParam(), times);
  const NonlinearElimination elimination(bar.solid, bar.equations);
  const std::vector<int> none;
  double before = bar.residual(u, &tangent).norm();
  for (int round = 0; round < 3; ++round) {
    const Eigen::VectorXd residual = bar.residual(u, &tangent);
    ASSERT_TRUE(elimination.solve(u, {residual, tangent, bar.history, 0, none}));
    EXPECT_LT(bar.residual(u, nullptr).norm(), 0.11 * before) << round; // a tenth is enough there
    before = bar.residual(u, nullptr).norm();
    for (std::size_t a = 0; round == 0 && a < bar.space.n_nodes; ++a) // farther than the disturbed cells' neighbours
      for (int i = 0; i < 3; ++i)
        if (const int e = bar.equations.of_dof[3 * a + i]; e >= 0 && std::abs(bar.space.positions[a].x() - 0.5) > 0.25)
          EXPECT_EQ(u[e], start[e]);
  }
  EXPECT_LT((u - solution).norm(), 2e-3 * (start - solution).norm()); // three rounds, each of which may leave a tenth
}
INSTANTIATE_TEST_SUITE_P(ByOneAndBothTriangles, Elimination, ::testing::Values(Symmetry::symmetric, Symmetry::general));

TEST(NonlinearElimination, LeavesWhatIsHeldAndWhatIsSpreadTooFar) {
  Bar bar;
  int equation = -1;
  Eigen::VectorXd u = disturbed(bar, equation);
  TimeSplit times;
  Tangent tangent(bar.equations.n, bar.solid.couplings(bar.equations), {}, Symmetry::symmetric, times);
  const NonlinearElimination elimination(bar.solid, bar.equations);
  const Eigen::VectorXd start = u, residual = bar.residual(u, &tangent);
  const std::vector<int> held{equation};
  elimination.solve(u, {residual, tangent, bar.history, 0, held});
  EXPECT_EQ(u[equation], start[equation]);
  u = start;
  ASSERT_GT(bar.equations.n, 900);
  EXPECT_FALSE(elimination.solve(u, {Eigen::VectorXd::Ones(bar.equations.n), tangent, bar.history, 0, {}}));
  EXPECT_EQ(u, start);
  std::vector<int> all_but_one;
  for (int e = 0; e < bar.equations.n; ++e)
    if (e != equation) all_but_one.push_back(e);
  ASSERT_TRUE(elimination.solve(u, {residual, tangent, bar.history, 0, all_but_one})); // by one equation alone
  EXPECT_NE(u[equation], start[equation]);
  EXPECT_EQ((u - start).cwiseAbs().sum(), std::abs(u[equation] - start[equation]));
}

/// x^3 = 8 from far off, y = 1: a change of both leaves much, x by itself is at hand at once.
struct Steep : NewtonTarget {
  TimeSplit times;
  Tangent tangent{2, {}, {{0, 1}}, Symmetry::general, times};
  Eigen::VectorXd r = Eigen::VectorXd::Zero(2);
  double found = 2;
  bool evaluate(const Eigen::VectorXd &u, bool) override {
    r << u[0] * u[0] * u[0] - 8, u[1] - 1;
    tangent.set_zero();
    tangent.add(0, 0, 3 * u[0] * u[0]);
    tangent.add(1, 1, 1);
    return true;
  }
  bool eliminate(Eigen::VectorXd &u) override {
    u[0] = found;
    return true;
  }
  const Eigen::VectorXd &residual() const override { return r; }
  double force_scale() const override { return 1; }
  LinearSolver &solver() override { return tangent.solver(); }
};

TEST(Newton, EliminatesWhereAChangeLeavesMuchAndKeepsWhatServed) {
  const auto solved = [](bool eliminates, double found) {
    Steep steep;
    steep.found = found;
    Eigen::VectorXd u = Eigen::Vector2d(40, 3);
    NewtonOptions options;
    options.eliminates = eliminates;
    const NewtonReport report = newton(steep, u, options);
    EXPECT_TRUE(report.converged()) << report.reason();
    EXPECT_NEAR(u[0], 2, 1e-6);
    EXPECT_NEAR(u[1], 1, 1e-6);
    return std::pair(report.iterations, steep.work.eliminations);
  };
  const auto [without, never] = solved(false, 2);
  const auto [with, once] = solved(true, 2);
  const auto [misled, tries] = solved(true, 1e3); // a worse place is not taken
  EXPECT_EQ(never, 0);
  EXPECT_EQ(once, 1);
  EXPECT_LT(with, without - 5);
  EXPECT_GT(tries, 3);
  EXPECT_EQ(misled, without);
}

TEST(CellAnswers, AreThoseThatWouldBeMadeAnew) {
  Bar bar;
  const Eigen::VectorXd u = bar.equations.gather(bar.stretched);
  int equation = -1;
  const Eigen::VectorXd other = disturbed(bar, equation);
  TimeSplit times;
  Tangent kept(bar.equations.n, bar.solid.couplings(bar.equations), {}, Symmetry::symmetric, times),
      anew(bar.equations.n, bar.solid.couplings(bar.equations), {}, Symmetry::symmetric, times);
  CellAnswers answers;
  bool moved = false;
  bar.energies = {};
  for (const auto &[at, with_tangent] :
       {std::pair{&u, true}, {&u, true}, {&other, false}, {&other, true}, {&u, false}}) {
    const Eigen::VectorXd by_answers = bar.forces(*at, with_tangent ? &kept : nullptr, &answers);
    const SolidHistory history = bar.next;
    const SolidEnergies energies = bar.energies;
    bar.next.clear();
    bar.energies = {};
    const Eigen::VectorXd by_cells = bar.forces(*at, with_tangent ? &anew : nullptr);
    EXPECT_EQ(by_answers, by_cells);
    EXPECT_EQ(energies.elastic, bar.energies.elastic);
    EXPECT_EQ(energies.plastic, bar.energies.plastic);
    EXPECT_GT(energies.plastic, 0);
    for (std::size_t i = 0; i < history.size(); ++i) {
      EXPECT_EQ(history[i].alpha, bar.next[i].alpha);
      EXPECT_EQ(history[i].cp_inverse, bar.next[i].cp_inverse);
    }
    if (with_tangent) EXPECT_EQ(kept.symmetric().values(), anew.symmetric().values());
    moved = moved || by_answers != bar.forces(u, nullptr);
    bar.next = history;
    bar.energies = {};
  }
  EXPECT_TRUE(moved);
  // Of the next step, whose history is another, nothing is known.
  bar.forces(u, nullptr, &answers);
  bar.history = bar.next;
  answers.begin();
  bar.energies = {};
  const Eigen::VectorXd relaxed = bar.forces(u, nullptr, &answers);
  EXPECT_EQ(relaxed, bar.forces(u, nullptr));
}

} // namespace
} // namespace rimpact::fe
