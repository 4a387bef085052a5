// A material that never yields and loses energy as it strains: closed forms of a point, a mass that swings on a column.
#include "blocks.h"
#include "fe_contact/engine/internal_forces.h"
#include "one_point.h"

#include <Eigen/Geometry>
#include <numbers>

namespace rimpact::fe {
namespace {

/// E = 200 GPa, nu = 0.3, as the tests' volume.
struct LossyPoint {
  PadLoss loss{1e-3};
  HenckyJ2 spring = HenckyJ2::from({200e9, 0.30, 7850.0});
  HenckyVolumetric volume = test::volumetric_part();
  IsochoricResult step(const J2State &old, const Matrix3 &F, double dt, bool with_tangent = true) const {
    return loss.step(spring, volume, old, F, dt, with_tangent);
  }
  Vector6 stress(const IsochoricResult &result, const Matrix3 &F) const {
    return result.response.stress + volume.at(F.determinant()).response.stress;
  }
};

TEST(PadLoss, ATangentOfRandomStepsAgreesWithDifferences) {
  const LossyPoint point;
  std::mt19937 generator(3);
  for (int sample = 0; sample < 10; ++sample) {
    const Matrix3 before = test::random_gradient(generator, 0.02);
    const J2State old = point.step({}, before, 1e-3).state;
    test::expect_consistent_tangent(
        point, old, before + 0.1 * test::random_gradient(generator, 0.02) - 0.1 * Matrix3::Identity(), 1e-3);
  }
}

TEST(PadLoss, AtAConstantRateTheDashpotBearsItsShareExactly) {
  const LossyPoint point;
  const double confined = point.volume.bulk_modulus + 4.0 / 3 * point.spring.shear_modulus, rate = 5, dt = 2e-4;
  J2State state;
  for (int i = 1; i <= 10; ++i) {
    const double strain = rate * i * dt;
    const Matrix3 F = Eigen::Vector3d(std::exp(strain), 1, 1).asDiagonal();
    const IsochoricResult result = point.step(state, F, dt);
    EXPECT_NEAR(point.stress(result, F)[0] / (confined * (strain + point.loss.retardation * rate)), 1, 1e-9);
    state = result.state;
  }
  const double power = confined * point.loss.retardation * rate * rate;
  EXPECT_NEAR(state.viscous_work / (power * (10 - 0.5) * dt), 1, 1e-9); // its first step begins without any
}

TEST(PadLoss, ATurnLosesNothingAndAStandingPointRelaxes) {
  const LossyPoint point;
  const Matrix3 F = Matrix3(Eigen::Vector3d(1.02, 0.99, 1.01).asDiagonal());
  const J2State pressed = point.step({}, F, 0).state;
  const Matrix3 turn = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const IsochoricResult turned = point.step(pressed, turn * F, 1e-4), elastic = point.spring.step({}, turn * F, 0);
  EXPECT_LT((turned.response.stress - elastic.response.stress).norm(), 1e-9 * elastic.response.stress.norm());
  EXPECT_LT(turned.state.viscous_work, 1e-9);
  const IsochoricResult struck = point.step({}, F, 1e-4), held = point.step(struck.state, F, 1e-4);
  EXPECT_GT(struck.response.stress.norm(), 5 * held.response.stress.norm());
  EXPECT_LT((held.response.stress - point.spring.step({}, F, 0).response.stress).norm(),
            1e-9 * held.response.stress.norm());
  EXPECT_NEAR(held.state.viscous_work / struck.state.viscous_work, 2, 1e-9); // the trapezoid ends where the power does
}

TEST(PadLoss, ACycleLosesTheLossFactorsShareOfItsEnergy) {
  const LossyPoint point;
  constexpr double omega = 50, amplitude = 1e-3;
  constexpr int steps = 2000;
  J2State state;
  double begun = 0;
  for (int i = 0; i <= 2 * steps; ++i) { // the second cycle, which has the first behind it
    const double phase = 2 * std::numbers::pi * i / steps, shear = amplitude * std::sin(phase);
    Matrix3 F = Matrix3::Identity();
    F(0, 1) = shear;
    state = point.step(state, F, 2 * std::numbers::pi / omega / steps).state;
    if (i == steps) begun = state.viscous_work;
  }
  const double largest = 0.5 * point.spring.shear_modulus * amplitude * amplitude;
  EXPECT_NEAR((state.viscous_work - begun) / (2 * std::numbers::pi * largest), point.loss.retardation * omega, 1e-5);
}

/// A column of the bearing's pad, held across, with a heavy body on it: k = (kappa + 4 mu / 3) A / t.
struct Column {
  static constexpr double side = 0.1, height = 0.04, mass = 500, loss_factor = 0.2;
  explicit Column(const scene::Bearing &bearing)
      : volume(HenckyVolumetric::from(bearing.ertalyte)), spring(HenckyJ2::from(bearing.ertalyte)),
        stiffness((volume.bulk_modulus + 4.0 / 3 * spring.shear_modulus) * side * side / height),
        omega(std::sqrt(stiffness / mass)), space(mesh(), 2), solid(space, bearing, loss_factor / omega),
        supports(space) {
    for (int i = 0; i < 2; ++i) supports.fix(i, [](const Vector3d &) { return true; });
    supports.fix(2, [](const Vector3d &x) { return x.z() < 1e-9; });
    supports.tie(Surface::top, 2);
    system.emplace(space, solid, supports.number());
    top_dof = 3 * space.nodes_of(Surface::top).front() + 2;
    system->add_mass(top_dof - 2, mass);
  }
  static meshes::HexMesh mesh() {
    meshes::HexMesh result;
    test::add_box(result, {{0, 0, 0}, {side, side, height}, {1, 1, 2}, Volume::pad, {{5, Surface::top}}});
    return result;
  }
  HenckyVolumetric volume;
  HenckyJ2 spring;
  double stiffness, omega;
  Discretisation space;
  Solid solid;
  Supports supports;
  std::optional<ContactSystem> system;
  int top_dof = 0;
};

TEST(PadLoss, AMassOnAColumnOfThePadSwingsDownAndTheLedgerHasIt) {
  const scene::Bearing bearing;
  Column column(bearing);
  const double dt = 2 * std::numbers::pi / column.omega / 400, speed = 1e-2;
  SystemState state = column.system->at_rest();
  const int top = column.system->equations().of_dof[column.top_dof];
  state.v[top] = speed;
  const double put_in = column.system->kinetic_energy(state), own = 1390 * column.side * column.side * column.height;
  ASSERT_LT(own, 2e-3 * column.mass);
  MotionOptions options;
  options.largest_step = options.contact_step = dt;
  options.smallest_step = 1e-3 * dt;
  options.step.rho_inf = 1, options.step.max_augmentations = 0;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.u.size());
  const double ratio = column.loss_factor / 2, damped = column.omega * std::sqrt(1 - ratio * ratio);
  double worst = 0;
  const auto report = run_in_time(
      *column.system, state, 3 * 2 * std::numbers::pi / column.omega, [&](double) { return none; }, options,
      [&](double t, const SystemState &now, const ContactStepReport &) {
        const double exact = speed / damped * std::exp(-ratio * column.omega * t) * std::sin(damped * t);
        worst = std::max(worst, std::abs(now.u[top] - exact));
      });
  ASSERT_TRUE(report.march.finished) << report.march.reason;
  EXPECT_LT(worst, 0.02 * speed / column.omega);
  EXPECT_GT(report.ledger.damping, 0.95 * put_in);
  EXPECT_LT(std::abs(report.ledger.imbalance_relative()), 2e-3); // of 400 steps a cycle, at a loss factor of 0.2
}

TEST(PadLoss, WhatACommittedStateBearsIsItsSpring) {
  const scene::Bearing bearing;
  Column column(bearing);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(column.space.n_dofs());
  for (std::size_t a = 0; a < column.space.n_nodes; ++a) u[3 * a + 2] = -1e-4 * column.space.positions[a].z();
  const Equations &equations = column.system->equations();
  Eigen::VectorXd fast = Eigen::VectorXd::Zero(equations.n);
  SolidHistory next;
  SolidEnergies energies;
  ASSERT_TRUE(column.solid.assemble(u, column.solid.initial_history(), next, equations, fast, nullptr, energies, 1e-4));
  const double still = 1e-4 * column.height * column.stiffness;
  EXPECT_NEAR(fast[equations.of_dof[column.top_dof]] / still, -(1 + column.loss_factor / column.omega / 1e-4), 1e-3);
  EXPECT_GT(energies.damping, 0);
  EXPECT_EQ(energies.plastic, 0);
  double sum = 0;
  const auto on_top = column.space.nodes_of(Surface::top);
  for (std::size_t c = 0; c < column.space.n_cells; ++c) {
    const Eigen::Matrix3Xd forces = internal_forces(column.solid, column.space, c, u, next);
    for (int a = 0; a < column.space.nodes_per_cell; ++a)
      if (std::find(on_top.begin(), on_top.end(), column.space.cell_nodes[c * column.space.nodes_per_cell + a]) !=
          on_top.end())
        sum += forces(2, a);
  }
  EXPECT_NEAR(sum / still, -1, 1e-3);
}

} // namespace
} // namespace rimpact::fe
