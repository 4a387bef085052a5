// Friction by pressure and temperature on two dishes: the tangent, the heat, and a single surface's limit.
#include "reduced_models/rigid_body/rigid_bearing.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

namespace rimpact::reduced::testing {
namespace {

using namespace rigid;
using Eigen::Vector3d;

scene::Scene measured(scene::ModelKind model) {
  scene::Scene s = shaken(model, 0.35);
  s.reduced.mu_slow = 0.03, s.reduced.rate = 20;
  s.reduced.measured.reference_pressure = 10e6, s.reduced.measured.by_temperature = true;
  return s;
}

} // namespace

TEST(RigidMeasuredFriction, TangentAgreesWithDifferences) {
  scene::Scene s = measured(scene::ModelKind::lir_dcfp);
  s.isolator.space = scene::Space::spatial, s.isolator.points = 8;
  RigidBearing bearing(s);
  bearing.system.temperature.fill(120);
  const MotionState state = bearing.state_at({0.15, 0.1}, {0.2, 0.3});
  const double weight = 1e-3;
  std::vector<Vector3d> slip(bearing.system.contacts.size(), Vector3d(0.5, 0.5, 0));
  std::vector<ContactForce> forces;
  const int n = bearing.system.n_dofs();
  const auto at = [&](const Vector &dv, Matrix *tangent) {
    Poses poses = state.poses;
    for (std::size_t b = 0; b < bearing.system.bodies.size(); ++b)
      poses[b] = moved_by(poses[b], weight * dv, static_cast<int>(b));
    return bearing.system.forces(poses, state.velocity + dv, {weight, weight, slip}, forces, tangent);
  };
  Matrix tangent, difference = Matrix::Zero(n, n);
  at(Vector::Zero(n), &tangent);
  for (int j = 0; j < n; ++j) {
    const Vector dv = 1e-6 * Vector::Unit(n, j);
    difference.col(j) = (at(dv, nullptr) - at(-dv, nullptr)) / 2e-6;
  }
  EXPECT_LT((tangent - difference).norm(), 2e-3 * difference.norm());
  // Every point rubs by the pressure on its share of the face.
  const auto &law = bearing.system.friction[0];
  at(Vector::Zero(n), nullptr);
  EXPECT_NEAR(law.area, std::numbers::pi * 0.15 * 0.15 / 8, 1e-12);
  EXPECT_LT(law.under(forces[0].size, 0.3, 120).value, law.under(forces[0].size, 0.3, 20).value);
}

TEST(RigidMeasuredFriction, BothDishesWarmAlikeAndEnergiesAddUp) {
  const auto run = simulate(measured(scene::ModelKind::dcfp));
  ASSERT_EQ(run.summary.status, RunStatus::done) << run.summary.reason;
  const auto &bottom = run.response.series("temperature"), &top = run.response.series("temperature_top");
  EXPECT_GT(bottom.back(), 21);
  for (std::size_t i = 0; i < bottom.size(); i += 50)
    EXPECT_NEAR(top[i] - 20, bottom[i] - 20, 0.05 * (bottom[i] - 20) + 0.3);
  EXPECT_LT(std::abs(run.summary.energy->imbalance_relative()), 1e-2);
  EXPECT_GE(run.summary.extra.at("friction").at("peak_temperature_C").get<double>(), bottom.back());
}

TEST(RigidMeasuredFriction, LessFrictionByPressureGoesFarther) {
  scene::Scene s = shaken(scene::ModelKind::dcfp, 0.35), by_pressure = s;
  by_pressure.reduced.measured.reference_pressure = 5e6; // it carries 28 MPa
  EXPECT_GT(simulate(by_pressure).summary.peak_displacement, simulate(s).summary.peak_displacement);
}

} // namespace rimpact::reduced::testing
