// Contact of a solid with exact surfaces: tangents against differences, cut-backs, the unsymmetric matrix.
#include "blocks.h"
#include "fe_contact/solver/general_matrix.h"

#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

struct ContactTangent : ::testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(ContactTangent, IsTheDerivativeOfTheForcesWhereSomePointsStickAndOthersSlip) {
  const auto [degree, rate] = GetParam();
  Block block({0.3, rate > 0 ? 0.1 : 0.3, rate}, degree);
  const Equations &equations = block.system->equations();
  SurfaceContact &contact = block.system->contact(0);
  SurfaceContactState state = contact.open(Eigen::VectorXd::Zero(equations.of_dof.size()));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd u(equations.n);
  for (int i = 0; i < equations.n; ++i) u[i] = 2e-5 * unit(random);
  for (int i = 0; i < 3; ++i) u[block.carrier_equations[i]] = i == 2 ? 3e-4 : 5e-5;
  for (auto &multiplier : state.tangential) multiplier = 3e5 * Vector3d(unit(random), unit(random), unit(random));

  ContactAtU here{contact, state, equations, u};
  ASSERT_NO_FATAL_FAILURE(here.expect_tangent(random));
  // What the body gets the carrier gives.
  Vector3d on_carrier, on_body = here.report.force;
  for (int i = 0; i < 3; ++i) on_carrier[i] = -here.forces[block.carrier_equations[i]];
  EXPECT_LT((on_carrier + on_body).norm(), 1e-9 * on_body.norm());
}
INSTANTIATE_TEST_SUITE_P(DegreeAndRate, ContactTangent,
                         ::testing::Combine(::testing::Values(1, 2), ::testing::Values(0.0, 20.0)));

/// Three steps of 1 ms pressing and dragging the block; `spoil`: every step is first tried over a far longer way.
SystemState dragged(bool spoil) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  for (int k = 1; k <= 3; ++k) {
    if (spoil) {
      SystemState trial = state;
      static_step(*block.system, trial, block.drive(20e-3 * k, 5e-4 * k, 1e-3), {});
    }
    EXPECT_TRUE(static_step(*block.system, state, block.drive(2e-4 * k, 1e-4 * k, 1e-3), {}).converged);
  }
  return state;
}

TEST(CutBack, LeavesNothingBehind) {
  const SystemState straight = dragged(false), cut = dragged(true);
  EXPECT_GT(straight.reports[0].slip, 0);
  EXPECT_LT((straight.u - cut.u).norm(), 1e-8 * straight.u.norm()); // Newton's tolerance: the factor may be another
  EXPECT_LT((straight.reports[0].force - cut.reports[0].force).norm(), 1e-9 * straight.reports[0].force.norm());
}

TEST(CutBack, AFailedStepLeavesTheStateAsItWas) {
  Block block(FrictionCoefficient::constant(0.3));
  SystemState state = block.system->at_rest();
  ASSERT_TRUE(static_step(*block.system, state, block.drive(1e-4, 1e-4, 1e-3), {}).converged);
  const SystemState before = state;
  const auto step = static_step(*block.system, state, block.drive(0, 0.2, 1e-3), {}); // through the whole block
  EXPECT_FALSE(step.converged);
  EXPECT_FALSE(step.reason.empty());
  EXPECT_EQ((state.u - before.u).norm(), 0);
  EXPECT_EQ(state.contacts[0].pressure, before.contacts[0].pressure);
}

TEST(SlidingBlock, PenaltyAndMultiplierAgreeOnTheFrictionForce) {
  for (const int augmentations : {0, 10}) {
    Block block(FrictionCoefficient::constant(0.3));
    SystemState state = block.system->at_rest();
    StepOptions options;
    options.max_augmentations = augmentations;
    for (int k = 1; k <= 4; ++k)
      ASSERT_TRUE(static_step(*block.system, state, block.drive(1e-3 * k, 1e-4, 1e-3), options).converged);
    const Vector3d force = state.reports[0].force;
    // Every point slips: the tangential force is mu times the normal one, but for the sphere's small slope.
    EXPECT_EQ(state.reports[0].stick, 0);
    EXPECT_NEAR(force.head<2>().norm() / force.z(), 0.3, 0.01) << augmentations;
  }
}

// m v' = -mu(v) m g with mu(v) = f - (f - s) exp(-a v): f exp(a v) - (f - s) falls as exp(-a f g t).
TEST(SlidingBlock, SlowsAsTheFrictionOverItsSpeedSays) {
  constexpr double fast = 0.2, slow = 0.05, rate = 8, g = 9.81, v0 = 0.5, end = 0.2;
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {0.4, 0.1, 0.1}, {2, 1, 1}, Volume::rim, {{4, Surface::slider_side}}});
  const Discretisation space(mesh, 2);
  const Solid solid(space, {{Volume::rim, scene::Material{block_modulus, 0.3, 1000, {}, {}}}});
  Supports supports(space);
  supports.fix(1, [](const Vector3d &) { return true; });
  ContactSystem system(space, solid, supports.number());
  system.add_contact(Surface::slider_side, plane(Vector3d::Zero(), Vector3d::UnitZ()),
                     {{block_modulus / 0.05, block_modulus / 0.05, {fast, slow, rate}}});
  SystemState state = system.at_rest();
  const Eigen::VectorXd weight = system.gravity({0, 0, -g});
  MotionOptions options{.step = {}, .largest_step = 2e-3, .smallest_step = 1e-6, .contact_step = 1e-4};
  ASSERT_TRUE(preload(system, state, weight, 1e6, options.step).converged);
  const auto &of = system.equations().of_dof;
  for (std::size_t dof = 0; dof < of.size(); dof += 3) state.v[of[dof]] = v0;
  const auto report = run_in_time(
      system, state, end, [&](double) { return weight; }, options,
      [](double, const SystemState &, const ContactStepReport &) {});
  ASSERT_TRUE(report.march.finished) << report.march.reason;
  const Eigen::VectorXd masses = system.gravity({1, 0, 0}); // by equation [kg]
  const double speed = masses.dot(state.v) / masses.sum();
  const double expected =
      std::log(((fast * std::exp(rate * v0) - (fast - slow)) * std::exp(-rate * fast * g * end) + (fast - slow)) /
               fast) /
      rate;
  EXPECT_NEAR(speed, expected, 2e-3 * v0);
  EXPECT_LT(report.imbalance(), 1e-3);
}

TEST(Ledger, CountsPointsThatLeaveOverAnEdgeAndThatComeOverIt) {
  constexpr double first_points = 0.1 * 0.0694318442, edge = first_points - 1e-3,
                   pressed = 6e-4; // the points from the face's side [m]
  Block block(FrictionCoefficient::constant(0), 2, [](const Vector3d &y) { return y.x() > edge; });
  SystemState state = block.system->at_rest();
  double elastic = 0, x = 0, z = 0;
  Vector3d force = Vector3d::Zero();
  const auto left_by = [&](double next_x, double next_z) {
    EXPECT_TRUE(static_step(*block.system, state, block.drive(next_x, next_z, 1e-3), {}).converged);
    const Vector3d moved(next_x - x, 0.3 * (next_x - x), next_z - z);
    const auto &report = state.reports[0];
    const double left =
        0.5 * (force + report.force).dot(moved) - (state.energies.elastic - elastic) - report.normal_work;
    elastic = state.energies.elastic, force = report.force, x = next_x, z = next_z;
    return std::abs(left);
  };
  left_by(0, pressed);
  const double stored = elastic, whole = force.z();
  EXPECT_LT(left_by(2e-3, pressed), 2e-3 * stored); // settled at its end: a column of points is past the edge
  EXPECT_LT(left_by(2.1e-3, pressed), 2e-3 * stored);
  EXPECT_LT(force.z(), 0.99 * whole);
  EXPECT_GT(state.reports[0].normal_work, 5e-3 * stored);
  EXPECT_LT(left_by(0, pressed), 2e-3 * stored); // they are back
}

/// An elastic block meets a plane at 0.1 m/s and is followed in steps of a thousandth of a wave's time through it; the
/// kinetic and elastic energy at the end over that at the start.
double energy_kept(double renewal_time) {
  const Discretisation space(Block::mesh(), 2);
  const Solid solid(space, {{Volume::rim, scene::Material{block_modulus, 0.3, 1000, {}, {}}}});
  Supports supports(space);
  ContactSystem system(space, solid, supports.number());
  system.add_contact(Surface::slider_side, plane(Vector3d::Zero(), Vector3d::UnitZ()),
                     {{block_modulus / 0.05, block_modulus / 0.05, FrictionCoefficient::constant(0)}});
  SystemState state = system.at_rest();
  for (std::size_t dof = 2; dof < system.equations().of_dof.size(); dof += 3)
    state.v[system.equations().of_dof[dof]] = -0.1;
  const double start = system.kinetic_energy(state);
  StepOptions options{.newton = {.tolerance = 1e-10}, .gap_tolerance = 1e-4};
  options.rho_inf = 1, options.expects = true, options.renewal_time = renewal_time;
  StepTerms terms{Eigen::VectorXd::Zero(system.equations().n)};
  terms.dt = 1e-7;
  for (int k = 0; k < 600; ++k) EXPECT_TRUE(time_step(system, state, terms, options).converged) << k;
  return (system.kinetic_energy(state) + state.energies.elastic) / start;
}

TEST(Renewal, MultipliersOfVeryShortStepsDoNotFeedTheRinging) {
  constexpr double through_block = 0.1 / 1000; // a wave's way, its speed sqrt(E / density)
  EXPECT_GT(energy_kept(0), 10);               // renewed wholly in each of the steps: out of nothing
  EXPECT_LT(energy_kept(through_block), 1.0);  // the rest is the penalty's
  EXPECT_GT(energy_kept(through_block), 0.6);
}

TEST(Entry, APointThatCameOverAnEdgeBearsByAndBy) {
  constexpr double edge = 0.1 * 0.0694318442 - 1e-3, pressed = 6e-4, width = 0.1 / 4; // of a point [m]
  struct Press {
    Block block{FrictionCoefficient::constant(0), 2, [](const Vector3d &y) { return y.x() > edge; }};
    SystemState state = block.system->at_rest();
    double at(double x) {
      EXPECT_TRUE(static_step(*block.system, state, block.drive(x, pressed, 1e-3), {}).converged);
      return state.reports[0].force.z();
    }
  };
  Press left, stayed; // one goes over the edge and comes back
  const double whole = stayed.at(0);
  left.at(0), left.at(2e-3);
  const double without = left.at(2.1e-3); // a column of points is past the edge
  left.at(0);                             // and is back, with all of its overlap
  const double missing = whole - without;
  EXPECT_LT(left.at(-1e-6), whole - 0.9 * missing); // so that nothing jumps
  double last = 0.95;
  for (const double way : {0.1, 0.2, 0.4, 0.8, 1.6, 3.2}) {
    const double still = (stayed.at(-way * width) - left.at(-way * width)) / missing;
    EXPECT_LT(still, last) << way;
    last = still;
  }
  EXPECT_LT(last, 0.05);
}

struct Carried : ::testing::TestWithParam<int> {};

TEST_P(Carried, TangentIsTheDerivativeAndActionIsReaction) {
  TwoBlocks blocks(GetParam());
  SurfaceContact &contact = *blocks.contact;
  const Equations &equations = blocks.equations;
  const Eigen::VectorXd u = blocks.moved({0.021, -0.013, -4e-4}, 2e-5);
  SurfaceContactState state = contact.open(blocks.moved({0.0209, -0.013, 0}, 0));
  const auto couplings = contact.couplings(equations, u, state.opposite);
  TimeSplit times;
  Tangent tangent(equations.n, {}, couplings, Symmetry::general, times);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n);
  const auto report = contact.assemble(u, state, 1e-3, equations, forces, &tangent);
  ASSERT_TRUE(report.pattern_holds);
  ASSERT_GT(report.stick, 0);
  ASSERT_GT(report.slip, 0);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t a = 0; a < blocks.space.n_nodes; ++a) sum += forces.segment<3>(3 * a);
  EXPECT_LT(sum.norm(), 1e-9 * report.force.norm());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 3; ++trial) {
    Eigen::VectorXd direction(equations.n);
    for (int i = 0; i < equations.n; ++i) direction[i] = unit(random);
    const double h = 1e-10;
    Eigen::VectorXd up = Eigen::VectorXd::Zero(equations.n), down = up;
    contact.assemble(u + h * direction, state, 1e-3, equations, up, nullptr);
    contact.assemble(u - h * direction, state, 1e-3, equations, down, nullptr);
    const Eigen::VectorXd expected = (up - down) / (2 * h);
    // Left out: how the reference face's own curvature changes the carrier's strain along it.
    EXPECT_LT((tangent.multiply(direction) - expected).norm(), 1e-3 * expected.norm());
  }
}
INSTANTIATE_TEST_SUITE_P(Degree, Carried, ::testing::Values(1, 2));

// Slip is measured in the carrier's reference configuration: on a carrier that is stretched by a twentieth it is
// shorter by that than the way on which the traction works.
TEST(Carried, OnAStretchedCarrierTheLedgerTakesWhatTheForcesDo) {
  TwoBlocks blocks(2);
  const auto displaced = [&](double way) { // the lower block stretched, the upper one pressed on it and moved
    Eigen::VectorXd u(blocks.equations.n);
    for (std::size_t c = 0; c < blocks.space.n_cells; ++c)
      for (int a = 0; a < blocks.space.nodes_per_cell; ++a) {
        const unsigned node = blocks.space.cell_nodes[c * blocks.space.nodes_per_cell + a];
        const double x = blocks.space.positions[node].x();
        u.segment<3>(3 * node) =
            blocks.space.volumes[c] == Volume::rim ? Vector3d(way, 0, -2e-4) : Vector3d(0.05 * x, 0, 0);
      }
    return u;
  };
  SurfaceContactState state = blocks.contact->open(displaced(0));
  Eigen::VectorXd u = displaced(0), forces = Eigen::VectorXd::Zero(blocks.equations.n);
  blocks.contact->couplings(blocks.equations, u, state.opposite); // the pairs that may meet
  for (const double way : {1e-4, 2e-4}) {                         // the first step makes it slip
    const SurfaceContactState before = state;
    const Eigen::VectorXd u_before = u, forces_before = forces;
    u = displaced(way);
    forces.setZero();
    auto report = blocks.contact->assemble(u, state, 0, blocks.equations, forces, nullptr);
    blocks.contact->add_work(before, state, blocks.contact->places(u, state), report);
    if (way > 1.5e-4) {
      ASSERT_GT(report.slip, 20);
      const double done = 0.5 * (forces_before + forces).dot(u - u_before);
      EXPECT_NEAR(report.friction_work + report.normal_work, done, 2e-3 * std::abs(report.friction_work));
    }
    blocks.contact->commit(u, blocks.contact->places(u, state), state, {NextMultipliers::same});
  }
}

TEST(Carried, MovedTogetherNothingSlips) {
  TwoBlocks blocks(2);
  SurfaceContactState state = blocks.contact->open(blocks.moved({0.021, 0, -1e-4}, 0));
  Eigen::VectorXd u = blocks.moved({0.021, 0, -1e-4}, 0);
  for (std::size_t a = 0; a < blocks.space.n_nodes; ++a) u.segment<3>(3 * a) += Vector3d(0.3, -0.2, 0.05);
  blocks.contact->couplings(blocks.equations, u, state.opposite);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(blocks.equations.n);
  const auto report = blocks.contact->assemble(u, state, 1e-3, blocks.equations, forces, nullptr);
  EXPECT_GT(report.stick, 0);
  EXPECT_EQ(report.slip, 0);
  EXPECT_LT(report.force.head<2>().norm(), 0.06 * report.force.z()); // the sphere's slope there is 0.01
}

} // namespace
} // namespace rimpact::fe
