// Laws as pure values: forces against formulas, derivatives against differences.
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/rigid_body/rim_memory.h"
#include "scenes.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::laws;

namespace {

/// Every number set, whether the law reads it or not.
RimElement element(const ImpactLaw &law) {
  if (law.pushed) return curve_element(std::make_shared<RimCurve>(reduced::testing::linear_curve(4.5e8, 9e8, 8e-3)));
  RimElement rim;
  rim.stiffness = 4.5e8, rim.damping = 1.7e6, rim.dissipation = 0.8, rim.impact_exponent = 1.3;
  rim.yield_force = 0.8e6, rim.hardening = 0.08, rim.hardening_exponent = 0.7;
  rim.unloading_gain = 0.5, rim.unloading_exponent = 1.6;
  rim.law = &law;
  return rim;
}
RimElement element(const std::string &law) {
  return element(impact_law(law));
}

void expect_consistent_tangent(const RimElement &rim, const RimMotion &m) {
  const double k = rim.stiffness, c = rim.damping, h = 1e-7;
  const auto force = [&](double dd, double dr, double ds) {
    return rim.at({m.d + dd, m.rate + dr, m.speed + ds, m.deepest}).force;
  };
  const auto at = rim.at(m);
  EXPECT_NEAR(at.d_penetration, (force(h, 0, 0) - force(-h, 0, 0)) / (2 * h), 1e-5 * k) << rim.law->name;
  EXPECT_NEAR(at.d_rate, (force(0, h, 0) - force(0, -h, 0)) / (2 * h), 1e-5 * c) << rim.law->name;
  EXPECT_NEAR(at.d_speed, (force(0, 0, h) - force(0, 0, -h)) / (2 * h), 1e-5 * c) << rim.law->name;
}

} // namespace

TEST(ImpactLaws, TangentsAgreeWithDifferences) {
  for (const auto *law : impact_laws())
    for (const double rate : {0.3, 0.0, -0.1, -0.9})
      for (const double deepest : {0.0, 1.2e-3, 4e-3})
        expect_consistent_tangent(element(*law), {1e-3, rate, std::abs(rate) + 0.05, deepest});
}

TEST(ImpactLaws, SignsInSeparation) {
  const double k = 4.5e8, c = 1.7e6, d = 1e-3;
  const RimMotion leaving{d, -0.5, 0.5, 0};
  EXPECT_DOUBLE_EQ(element("signed").at(leaving).force, k * d - c * 0.5);
  EXPECT_LT(element("signed").at(leaving).force, 0);
  EXPECT_EQ(element("no-tension").at(leaving).force, 0);
  EXPECT_DOUBLE_EQ(element("no-tension").trial(leaving), k * d - c * 0.5);
  EXPECT_DOUBLE_EQ(element("printed").at(leaving).force, k * d + c * 0.5);
}

TEST(ImpactLaws, HuntCrossleyByItsOwnFormula) {
  const auto rim = element("hunt-crossley");
  EXPECT_DOUBLE_EQ(rim.at({1e-3, 0}).force, 4.5e5); // k_i is the secant stiffness at 1 mm
  EXPECT_NEAR(rim.at({3e-3, 0.2}).force, 4.5e5 * std::pow(3, 1.3) * 1.16, 1e-6);
  EXPECT_EQ(rim.at({1e-3, -2}).force, 0); // never pulls
  // small losses: e = 1 - (2/3) chi v, Hunt and Crossley (1975)
  EXPECT_NEAR(hunt_crossley_dissipation(0.999, 0.5), 1.5 * 0.001 / 0.5, 1e-5);
  EXPECT_EQ(hunt_crossley_dissipation(1, 0.5), 0);
  EXPECT_NEAR(hunt_crossley_dissipation(0.3, 0.5), 2 * hunt_crossley_dissipation(0.3, 1.0), 1e-12);
  EXPECT_THROW(hunt_crossley_dissipation(0, 0.5), InputError);
  EXPECT_THROW(hunt_crossley_dissipation(0.5, 0), InputError);
}

TEST(ImpactLaws, ElastoplasticByItsOwnFormula) {
  const auto rim = element("elastoplastic");
  const double k = rim.stiffness, Fy = rim.yield_force;
  EXPECT_NEAR(rim.at({1e-9, 0.1}).d_penetration, k, 1e-4 * k);
  const double knee = Fy / (0.92 * k), far = k * 0.2 / Fy; // the knee's term has 1 / sqrt 2 of F_y there
  EXPECT_NEAR(rim.at({knee, 0.1}).force, Fy / std::sqrt(2.0) + 0.08 * Fy * (std::pow(1 + 1 / 0.92, 0.7) - 1) / 0.7,
              1e-9 * Fy);
  EXPECT_NEAR(rim.at({0.2, 0.1}).d_penetration, 0.08 * k * std::pow(1 + far, -0.3), 1e-5 * k); // hardening
  EXPECT_NEAR(rim.at({0.2, 0.1}).force, Fy + 0.08 * Fy * (std::pow(1 + far, 0.7) - 1) / 0.7, 1e-3 * Fy);
  const double deepest = 5e-3, top = rim.at({deepest, 0}).force,
               slope = k * (1 + 0.5 * std::pow(k * deepest / Fy, 1.6));
  ASSERT_GT(top, Fy);
  const double length = 1.5 * top / slope;
  EXPECT_NEAR(rim.at({deepest - 0.3 * length, 0.1, 0.1, deepest}).force, top * (0.7 + 0.49) / 2, 1e-9 * top);
  for (const double s : {0.1, 0.3, 0.5, 0.7, 0.9})
    EXPECT_NEAR(rim.at({deepest - (1 - s) * length, 0, 0, deepest}).force, top * std::pow(s, 1.4), 0.016 * top);
  EXPECT_NEAR(rim.at({deepest - 1e-12, 0.1, 0.1, deepest}).d_penetration, slope, 1e-6 * slope);
  EXPECT_NEAR(residual_indentation(rim, deepest), deepest - length, 1e-15);
  EXPECT_EQ(rim.at({residual_indentation(rim, deepest) - 1e-6, 0.1, 0.1, deepest}).force, 0);
  EXPECT_LT(rim.trial({residual_indentation(rim, deepest) - 1e-6, 0.1, 0.1, deepest}), 0);
  EXPECT_NEAR(rim.at({deepest + 1e-12, 0, 0, deepest}).force, top, 1e-3); // continuous where it yields again
}

TEST(ImpactLaws, ElastoplasticIsElasticWhereItHardlyYields) {
  const auto rim = element("elastoplastic");
  const double k = rim.stiffness, deepest = 1e-7; // far below F_y / k
  EXPECT_NEAR(residual_indentation(rim, deepest), 0, 1e-17);
  EXPECT_NEAR(rim.at({0.5 * deepest, -0.1, 0.1, deepest}).force, 0.5 * k * deepest, 1e-4 * k * deepest);
  EXPECT_NEAR(unloading(rim, deepest).elastic_energy(), 0.5 * k * deepest * deepest, 1e-4 * k * deepest * deepest);
  EXPECT_LT(rim.trial({-1e-3, 0.1, 0.1, 0}), 0); // short of a fresh rim
}

TEST(RimMemory, KeepsArcsApart) {
  RimMemory rim;
  rim.press({0.4, 0}, 1e-3);
  rim.press({0.4 * std::cos(0.1), 0.4 * std::sin(0.1)}, 2e-3); // 5.7 degrees on: the same arc
  rim.press({0, -0.4}, 3e-3);
  EXPECT_EQ(rim.dents().size(), 2u);
  EXPECT_EQ(rim.deepest_at({1, 0}), 2e-3);
  EXPECT_EQ(rim.deepest_at({0, -7}), 3e-3);
  EXPECT_EQ(rim.deepest_at({1, 1}), 0);
  rim.press({1, 0}, 1e-3); // shallower: nothing forgotten
  EXPECT_EQ(rim.deepest_at({1, 0}), 2e-3);
}

TEST(ImpactLaws, DampingOfTheThesis) {
  EXPECT_NEAR(damping_ratio(0.65), 0.13585, 5e-6); // notes, item 7
  EXPECT_EQ(damping_ratio(1.0), 0.0);
  EXPECT_NEAR(damping_coefficient(4.5e8, 0.65, 86952), 2 * 0.13585 * std::sqrt(4.5e8 * 86952), 200);
  EXPECT_THROW(damping_ratio(0), InputError);
  EXPECT_THROW(damping_ratio(1.01), InputError);
  EXPECT_THROW(damping_ratio(std::nan("")), InputError);
}

TEST(SmoothedFriction, DerivativeAgreesWithDifferencesAndTendsToCoulomb) {
  for (const bool socket : {false, true}) {
    scene::Scene s = reduced::testing::ricker();
    s.reduced.socket_friction = s.reduced.finite_pad = socket;
    s.reduced.mu_slow = 0.03, s.reduced.rate = 20;
    const PhysicalModel model(s);
    const auto p = model.height(0.3, 0.2);
    const Eigen::Vector3d u(0.3, 0.2, p.z), v(0.02, -0.05, p.gradient.dot(Eigen::Vector2d(0.02, -0.05)));
    const auto f = model.smoothed_friction(u, v, 8e5, 1e-2);
    for (int j = 0; j < 3; ++j) {
      const double h = 1e-6;
      const Eigen::Vector3d dv = h * Eigen::Vector3d::Unit(j);
      const Eigen::Vector3d slope =
          (model.smoothed_friction(u, v + dv, 8e5, 1e-2).force - model.smoothed_friction(u, v - dv, 8e5, 1e-2).force) /
          (2 * h);
      EXPECT_NEAR((f.d_velocity.col(j) - slope).norm(), 0, 1e-3 * f.d_velocity.norm()) << j;
      EXPECT_NEAR((f.d_velocity.col(j) - slope).norm(), 0, 2.0) << j;
    }
    EXPECT_NEAR((8e5 * f.d_normal - f.force).norm(), 0, 1e-6 * f.force.norm());
    EXPECT_LT(f.force.dot(v), 0);
    // sharp: the sliding force of the model itself
    BearingState state;
    state.u = u, state.v = v;
    const auto exact = model.forces(state);
    const auto sharp = model.smoothed_friction(u, v, exact.normal, 1e-9).force;
    EXPECT_NEAR((sharp - exact.friction).norm(), 0, 1e-6 * exact.friction.norm());
  }
}
