// The pair of the law no-tension that meets a peak force and a rebound.
#include "calibration/laws/no_tension_pair.h"
#include "laws/impact/catalogue.h"
#include "reduced_models/simulate.h"
#include "synthetic.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

TEST(NoTensionPair, IsWhatTheReducedModelFlies) {
  for (const double e : {0.02, 0.3, 0.65, 0.95})
    for (const double v : {0.1, 0.8}) {
      auto scene = window(v, 3e8, e);
      scene.reduced.impact_law = &laws::impact_law("no-tension");
      const auto impact = reduced::simulate(scene).summary.impacts.at(0);
      EXPECT_NEAR(impact.restitution(), no_tension_rebound(e), 1e-3) << e;
      const auto pair = no_tension_pair(impact.peak_force, impact.restitution(), v, scene.load.mass);
      ASSERT_TRUE(pair);
      EXPECT_NEAR(pair->k_i / 3e8, 1, 2e-3) << e;
      EXPECT_NEAR(pair->e, e, 1e-3) << e;
    }
  EXPECT_FALSE(no_tension_pair(1e6, 0.12, 0.5, 1e5)); // below exp(-2): no such law rebounds so little
  EXPECT_FALSE(no_tension_pair(1e6, 1.01, 0.5, 1e5));
}

} // namespace
} // namespace rimpact::calibration
