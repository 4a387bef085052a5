// Laws of a rim that yields, in whole impacts: against energy balances, not against the stepper.
#include "laws/impact/catalogue.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::laws;
using namespace rimpact::reduced::testing;

namespace {

scene::Scene struck(const std::string &law, double speed) {
  scene::Scene s = window(speed);
  s.reduced.impact_law = &laws::impact_law(law);
  return s;
}

/// Penetration at which the backbone has taken m v^2 / 2, by Simpson's rule and bisection.
double deepest_of(const RimElement &rim, double energy) {
  const auto work = [&](double d) {
    constexpr int n = 2000;
    double sum = 0;
    for (int i = 0; i <= n; ++i)
      sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * elastoplastic_backbone(rim, d * i / n).force;
    return sum * d / (3 * n);
  };
  double low = 0, high = 1;
  while (high - low > 1e-15) (work((low + high) / 2) < energy ? low : high) = (low + high) / 2;
  return low;
}

} // namespace

TEST(YieldingRim, HuntCrossleyReturnsEAtItsReferenceSpeedOnly) {
  for (const double e : {0.2, 0.65, 0.95})
    for (const double n : {0.8, 1.0, 1.5}) {
      scene::Scene s = struck("hunt-crossley", 0.5);
      s.excitation.duration = 1;
      s.reduced.restitution = e, s.reduced.impact_exponent = n;
      EXPECT_NEAR(simulate_summary(s).impacts.at(0).restitution(), e, 2e-6) << e << " " << n;
      s.excitation.speed = 0.1;
      EXPECT_GT(simulate_summary(s).impacts.at(0).restitution(), e) << e << " " << n;
    }
}

TEST(YieldingRim, ElastoplasticBalancesEnergy) {
  for (const double v : {0.02, 0.1, 0.5, 1.0}) {
    const scene::Scene s = struck("elastoplastic", v);
    const auto rim = s.reduced.element(s.load.mass);
    const double deepest = deepest_of(rim, s.load.mass * v * v / 2), top = elastoplastic_backbone(rim, deepest).force,
                 rebound = std::sqrt(2 * unloading(rim, deepest).elastic_energy() / s.load.mass);
    const auto impact = simulate_summary(s).impacts.at(0);
    EXPECT_NEAR(impact.peak_force / top, 1, 1e-6) << v;
    EXPECT_NEAR(impact.peak_penetration / deepest, 1, 1e-6) << v;
    EXPECT_NEAR(impact.rebound_speed / rebound, 1, 1e-6) << v;
  }
}

// m v^2 / 2 is the area below two straight lines; F^2 / (2 k) comes back
TEST(YieldingRim, BilinearBalancesEnergy) {
  for (const double v : {0.02, 0.1, 0.5, 1.0}) {
    const scene::Scene s = struck("bilinear", v);
    const auto rim = s.reduced.element(s.load.mass);
    const double m = s.load.mass, k = rim.stiffness, F_y = rim.yield_force, h = rim.hardening,
                 elastic = F_y * F_y / (2 * k), energy = m * v * v / 2,
                 beyond =
                     energy <= elastic ? 0 : (-F_y + std::sqrt(F_y * F_y + 2 * h * k * (energy - elastic))) / (h * k),
                 top = energy <= elastic ? v * std::sqrt(k * m) : F_y + h * k * beyond;
    const auto impact = simulate_summary(s).impacts.at(0);
    EXPECT_NEAR(impact.peak_force / top, 1, 1e-6) << v;
    EXPECT_NEAR(impact.rebound_speed / (top / std::sqrt(k * m)), 1, 1e-6) << v;
    if (beyond > 0) {
      EXPECT_NEAR(impact.peak_penetration / (F_y / k + beyond), 1, 1e-6) << v;
      EXPECT_NEAR(residual_indentation(rim, impact.peak_penetration), impact.peak_penetration - top / k, 1e-9) << v;
    }
  }
}

// what an answer's errors of k_i and of the depth are read from: the energy is stored on a way shorter by the share
// that the force is higher
TEST(YieldingRim, AHigherForceIsMetOnAShorterWayAndTwiceInTheStiffness) {
  for (const char *law : {"elastoplastic", "bilinear"}) {
    scene::Scene s = struck(law, 0.4);
    const auto plain = simulate_summary(s).impacts.at(0);
    s.reduced.k_i *= 1.1 * 1.1, s.reduced.yield_force *= 1.1;
    const auto higher = simulate_summary(s).impacts.at(0);
    EXPECT_NEAR(higher.peak_force / plain.peak_force, 1.1, 1e-6) << law;
    EXPECT_NEAR(higher.peak_penetration / plain.peak_penetration, 1 / 1.1, 1e-6) << law;
    EXPECT_NEAR(higher.rebound_speed / plain.rebound_speed, 1, 1e-6) << law;
  }
}

TEST(YieldingRim, TheSecondImpactFindsTheDent) {
  // thrown twice at the same arc: the rim is met only at the dent's bottom, and a lighter second hit is
  // elastic
  const scene::Scene s = struck("elastoplastic", 0.5);
  const auto rim = s.reduced.element(s.load.mass);
  const double L_c = s.bearing.lateral_capacity();
  const double deepest = simulate_summary(s).impacts.at(0).peak_penetration;
  BearingState again = PhysicalModel(s).initial_state();
  again.v.x() = 0.05;
  again.rim.press({1, 0}, deepest, dent_shape(s));
  const auto second = simulate_from(s, again, 0.4);
  ASSERT_EQ(second.summary.impacts.size(), 1u);
  const auto &impact = second.summary.impacts[0];
  EXPECT_NEAR(impact.touch_time, residual_indentation(rim, deepest) / 0.05, 1e-6);
  EXPECT_NEAR(impact.rebound_speed, 0.05, 1e-7);
  EXPECT_LT(impact.peak_penetration, deepest);
  again.u.head<2>() = Eigen::Vector2d(0, L_c), again.v.head<2>() = Eigen::Vector2d(0, 0.05);
  const auto elsewhere = simulate_from(s, again, 0.4); // a fresh arc
  EXPECT_NEAR(elsewhere.summary.impacts.at(0).touch_time, 0, 1e-9);
}

TEST(YieldingRim, AHarderSecondImpactGoesOnAlongTheBackbone) {
  const scene::Scene s = struck("elastoplastic", 0.2);
  const auto rim = s.reduced.element(s.load.mass);
  BearingState again = PhysicalModel(s).initial_state();
  again.v.x() = 0.5;
  again.rim.press({1, 0}, 2e-3, dent_shape(s));
  const auto impact = simulate_from(s, again, 0.4).summary.impacts.at(0);
  EXPECT_NEAR(impact.peak_force, elastoplastic_backbone(rim, impact.peak_penetration).force, 1e-6 * impact.peak_force);
  // what is left of the energy above the elastic part of the dent: reached from the dent as from its force
  const double whole = s.load.mass * 0.5 * 0.5 / 2 - unloading(rim, 2e-3).elastic_energy();
  const double to_dent = simulate_summary(struck("elastoplastic", 0.5)).impacts.at(0).peak_penetration;
  EXPECT_GT(impact.peak_penetration, to_dent); // the dent costs nothing this time
  double work = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i)
    work += elastoplastic_backbone(rim, 2e-3 + (impact.peak_penetration - 2e-3) * (i + 0.5) / n).force *
            (impact.peak_penetration - 2e-3) / n;
  EXPECT_NEAR(work / whole, 1, 1e-6);
}

TEST(YieldingRim, PushAndReturnLeavesTheResidualIndentation) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::push;
  s.excitation.travel = 0.008;
  s.excitation.unload = true;
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  const auto rim = s.reduced.element(s.load.mass);
  const auto run = simulate(s);
  const auto &gap = run.response.series("gap"), &force = run.response.series("impact_x");
  double deepest = 0, left = 0, peak = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    deepest = std::max(deepest, -gap[i]);
    if (-force[i] > 0) left = -gap[i];
    peak = std::max(peak, -force[i]);
  }
  EXPECT_NEAR(deepest, 0.008, 1e-12);
  EXPECT_NEAR(peak, elastoplastic_backbone(rim, 0.008).force, 1e-6 * peak);
  EXPECT_NEAR(left, residual_indentation(rim, 0.008), 2e-5); // one sample of the path
  EXPECT_GT(left, 0.003);
}
