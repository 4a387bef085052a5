// Recorded friction opposes the recorded velocity, also in the step that ends at a reversal or a stop.
#include "reduced_models/simulate.h"
#include "scenes.h"
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::reduced;
using namespace rimpact::reduced::testing;

namespace {

struct Opposition {
  double worst = -1;       ///< largest cosine between friction and velocity
  int n_slow = 0;          ///< samples moving slower than 10 mm/s
  double peak_power = 0.0; ///< largest friction . v [W]
};

Opposition opposition(const Response &r) {
  Opposition o;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Eigen::Vector2d v(r.series("velocity_x")[i], r.series("velocity_y")[i]),
        f(r.series("friction_x")[i], r.series("friction_y")[i]);
    if (v.norm() < 1e-6 || f.norm() < 1) continue; // at rest, or in the air
    o.n_slow += v.norm() < 0.01;
    o.worst = std::max(o.worst, v.dot(f) / v.norm() / f.norm());
  }
  return o;
}

void expect_opposed(scene::Scene s) {
  s.reduced.output_step = 2e-4; // many samples in the steps that end at v = 0
  for (const auto &run : {simulate(s), simulate_with_cvode(s)}) {
    const Opposition o = opposition(run.response);
    EXPECT_LT(o.worst, -0.9999);
    EXPECT_GT(o.n_slow, 10);
  }
}

} // namespace

TEST(FrictionSign, StraightMotionThroughItsReversals) {
  expect_opposed(ricker(1.05));
  expect_opposed(ricker(1.4));
}
TEST(FrictionSign, ObliqueMotion) {
  scene::Scene s = ricker(1.05);
  s.excitation.direction_deg = 37;
  expect_opposed(s);
}
TEST(FrictionSign, MotionThatTurnsWhileItStops) {
  expect_opposed(free_motion({0.35, 0}, {0.5, 2}));
  expect_opposed(scene::load_scene("pulse-bidirectional"));
}

/// At the deepest point of a straight impact friction jumps from one side to the other: both are stored, a microsecond
/// apart.
TEST(FrictionSign, BothSidesOfAJumpWithinContactAreStored) {
  const scene::Scene s = ricker();
  for (const auto &run : {simulate(s), simulate_with_cvode(s)}) {
    const auto &t = run.response.series("time"), &u = run.response.series("displacement_x"),
               &f = run.response.series("friction_x"), &N = run.response.series("normal_force");
    ASSERT_FALSE(run.summary.impacts.empty());
    for (const auto &impact : run.summary.impacts) {
      double jump = 0, expected = 0, deepest = 0, deepest_at_jump = 0;
      for (std::size_t i = 1; i < t.size(); ++i) {
        if (t[i - 1] < impact.touch_time || t[i] > impact.release_time) continue;
        deepest = std::max(deepest, std::abs(u[i]));
        if (!(t[i] - t[i - 1] < 2e-6) || std::abs(f[i] - f[i - 1]) < jump) continue;
        jump = std::abs(f[i] - f[i - 1]), expected = std::abs(f[i]) + std::abs(f[i - 1]),
        deepest_at_jump = std::abs(u[i]);
        EXPECT_NEAR(std::abs(f[i]), 0.07 * N[i], 0.25 * 0.07 * N[i]); // its tangent's horizontal part
      }
      EXPECT_GT(jump, 0.9 * expected);
      EXPECT_GT(jump, 1e5);
      EXPECT_NEAR(deepest_at_jump, deepest, 1e-10);
    }
  }
}
