// One impact alone: the closed forms of a mass on a Kelvin-Voigt rim.
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::laws;
using namespace rimpact::reduced::testing;

namespace {

constexpr double k = 4.5e8, m = 86952;

Impact impact_of(const std::string &law, double e = 0.65, double speed = 0.1, double direction = 0) {
  scene::Scene s = window(speed);
  s.reduced.impact_law = &laws::impact_law(law);
  s.reduced.restitution = e;
  s.excitation.direction_deg = direction;
  const auto summary = simulate_summary(s);
  EXPECT_EQ(summary.impacts.size(), 1u);
  EXPECT_LT(std::abs(summary.energy->imbalance_relative()), 1e-6);
  return summary.impacts.at(0);
}

} // namespace

TEST(Window, Signed) {
  const double xi = damping_ratio(0.65), w = std::sqrt(k / m), wd = w * std::sqrt(1 - xi * xi);
  const auto i = impact_of("signed");
  EXPECT_NEAR(i.release_time - i.touch_time, std::numbers::pi / wd, 1e-9); // 44 ms
  EXPECT_NEAR(i.release_time - i.touch_time, 0.044, 1e-3);
  EXPECT_NEAR(i.restitution(), 0.65, 1e-7);
  EXPECT_NEAR(i.peak_force / (0.1 * std::sqrt(k * m)), 0.853, 5e-4);
  // k d + c d' of the free damped vibration, maximised on a fine grid
  const double c = 2 * xi * std::sqrt(k * m);
  double best = 0;
  for (double t = 0; t < 0.044; t += 1e-6) {
    const double decay = 0.1 * std::exp(-xi * w * t), d = decay / wd * std::sin(wd * t);
    best = std::max(best, k * d + c * (decay * std::cos(wd * t) - xi * w * d));
  }
  EXPECT_NEAR(i.peak_force, best, 1e-7 * best);
}

TEST(Window, NoTension) {
  const double xi = damping_ratio(0.65);
  const auto i = impact_of("no-tension");
  EXPECT_NEAR(i.restitution(), std::exp(-xi / std::sqrt(1 - xi * xi) * (std::numbers::pi - 2 * std::asin(xi))), 1e-7);
  EXPECT_NEAR(i.restitution(), 0.675, 5e-4);
  EXPECT_NEAR(i.release_time - i.touch_time, 0.040, 5e-4);
}

TEST(Window, PrintedIsElasticWhateverE) {
  for (const double e : {0.05, 0.65, 1.0}) EXPECT_NEAR(impact_of("printed", e).restitution(), 1.0, 1e-7);
}

TEST(Window, ScalesWithSpeedAndKnowsNoDirection) {
  const auto slow = impact_of("signed", 0.65, 0.05), fast = impact_of("signed", 0.65, 1.0, 217);
  EXPECT_NEAR(fast.peak_force / slow.peak_force, 20, 1e-6);
  EXPECT_NEAR(fast.restitution(), slow.restitution(), 1e-7);
  EXPECT_NEAR(fast.direction_deg, -143, 1e-9);
}

TEST(Window, ExtremeRestitutions) {
  EXPECT_NEAR(impact_of("signed", 1.0).restitution(), 1.0, 1e-7);
  EXPECT_NEAR(impact_of("signed", 1.0).peak_force, 0.1 * std::sqrt(k * m), 1e-6 * 0.1 * std::sqrt(k * m));
  const auto soft = impact_of("signed", 0.05);
  EXPECT_NEAR(soft.restitution(), 0.05, 1e-7);
  // overdamped enough that the force is largest at touch, c v
  EXPECT_NEAR(soft.peak_force, 0.1 * damping_coefficient(k, 0.05, m), 1e-6 * soft.peak_force);
}

TEST(Window, FrictionAloneSlowsByMuW) {
  scene::Scene s = window(0.5);
  s.excitation.with_friction = true;
  s.reduced.k_i = 0; // slides on in the plane
  const auto run = simulate(s);
  const double a = 0.07 * s.load.vertical / s.load.mass;
  const auto &t = run.response.series("time"), &v = run.response.series("velocity_x");
  for (std::size_t i = 0; i < t.size(); ++i) ASSERT_NEAR(v[i], std::max(0.0, 0.5 - a * t[i]), 1e-7);
}

TEST(Window, WeightPullsBack) {
  scene::Scene s = window(0.2);
  s.excitation.with_weight = true;
  EXPECT_TRUE(simulate_summary(s).min_normal_force.has_value());
  EXPECT_FALSE(simulate_summary(window(0.2)).min_normal_force.has_value()); // nothing bears on the dish
  const auto heavy = simulate_summary(s).impacts.at(0);
  EXPECT_GT(heavy.restitution(), 0.65); // the slope gives speed back: not e
  EXPECT_LT(heavy.peak_force, impact_of("signed", 0.65, 0.2).peak_force);
}

TEST(Window, SamplesAreDenseAndEndExactly) {
  const auto run = simulate(window(0.3));
  const auto &r = run.response;
  std::size_t n = 0, last = 0;
  for (std::size_t i = 0; i < r.size(); ++i)
    if (r.series("impact_x")[i] != 0) ++n, last = i;
  EXPECT_GE(n, 100u);
  EXPECT_NE(r.series("impact_x")[0], 0); // touch is the start
  EXPECT_NEAR(r.series("time")[last], run.summary.impacts[0].release_time, 1e-12);
  Summary again;
  summarise_response(r, again);
  ASSERT_EQ(again.impacts.size(), 1u);
  EXPECT_NEAR(again.impacts[0].restitution(), 0.65, 1e-7);
  EXPECT_NEAR(again.impacts[0].peak_force, run.summary.impacts[0].peak_force, 1e-3 * again.impacts[0].peak_force);
}

TEST(Window, ATouchRightAfterTheFirstSampleHasItsOwn) {
  const scene::Scene s = window(0.3);
  BearingState start = PhysicalModel(s).initial_state();
  for (const double gap : {1e-12, 1e-8, 1e-7, 1e-6, 1e-5}) {
    start.u.x() = s.bearing.lateral_capacity() - gap;
    const auto r = simulate_from(s, start, 0.01).response;
    const auto &force = r.series("impact_x");
    std::size_t i = 0;
    while (force.at(i) == 0) ++i;
    EXPECT_NEAR(r.series("time")[i], gap / 0.3, 2e-9) << gap; // where a dashpot's force begins
    EXPECT_NEAR(-force[i], damping_coefficient(k, 0.65, m) * 0.3, 1e-6 * -force[i]) << gap;
  }
}
