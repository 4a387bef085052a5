#include "calibration/fit/shooting.h"
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include "synthetic.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

TEST(ImpactWindow, ShootingWithTheTruthRepeatsTheRun) {
  for (const auto &scene : {ricker(1.1), window(0.3)}) {
    const StoredRun run = run_of(scene);
    ASSERT_FALSE(run.impacts.empty());
    for (const auto &w : run.impacts) {
      const Shot shot = shoot(scene, w);
      for (std::size_t i = 0; i < w.times.size(); ++i) {
        EXPECT_NEAR(shot.displacement[i], w.displacement[i], 1e-8) << scene.name << " t " << w.times[i];
        if (w.force[i] >= 0.05 * w.peak) {
          EXPECT_NEAR(shot.force[i], w.force[i], 1e-5 * w.peak) << w.times[i];
        }
      }
      EXPECT_NEAR(shot.peak, w.peak, 1e-6 * w.peak);
      EXPECT_NEAR(shot.rebound_speed, w.impact.rebound_speed, 1e-7);
      EXPECT_FALSE(w.dented);
      EXPECT_DOUBLE_EQ(w.capacity, scene.bearing.lateral_capacity());
    }
  }
}

TEST(ImpactWindow, KnowsWhichImpactsGraze) {
  const StoredRun clear = run_of(ricker(1.1)), isolated = run_of(window(0.05));
  EXPECT_FALSE(clear.impacts.front().grazing);
  EXPECT_GT(clear.impacts.front().overshoot, 0.01);
  EXPECT_FALSE(isolated.impacts.front().grazing); // nothing but the rim stops an isolated mass, however slow
  auto slow = window(0.05);
  slow.excitation.with_weight = true;
  const StoredRun heavy = run_of(slow);
  EXPECT_LT(heavy.impacts.front().overshoot, 0.004); // its dish would nearly stop it, but its speed is given
  EXPECT_FALSE(heavy.impacts.front().grazing);
}

TEST(ImpactWindow, FollowsADentedRimToItsOwnTouch) {
  // the same impact, 3 mm farther out: a rim that yielded there before
  const auto scene = window(0.3);
  auto response = reduced::simulate(scene).response;
  const double dent = 3e-3;
  for (auto &u : response.series("displacement_x")) u += dent;
  for (auto &gap : response.series("gap")) gap -= dent;
  // an approach without rim force before it
  Response longer = response;
  for (const auto &[name, values] : response.all()) {
    const double first = values.front(), v = 0.3, dt = 2e-3;
    double before = first;
    if (name == "time") before = first - dt;
    if (name == "displacement_x") before = first - v * dt;
    if (name == "gap") before = first + v * dt;
    if (name.rfind("impact", 0) == 0 || name.rfind("force", 0) == 0) before = 0;
    longer.series(name).insert(longer.series(name).begin(), before);
  }
  const StoredRun run = make_run("dented", scene, longer, {});
  ASSERT_EQ(run.impacts.size(), 1u);
  const auto &w = run.impacts.front();
  EXPECT_TRUE(w.dented);
  EXPECT_NEAR(w.capacity, scene.bearing.lateral_capacity() + dent, 1e-3);
  // The gap of docs/interface.md starts the reduced rim at L_c, where the run holds no state before touch
  const StoredRun by_gap = make_run("dented", scene, longer, {.touch = TouchReference::gap});
  EXPECT_TRUE(by_gap.impacts.empty());
  EXPECT_NE(by_gap.notes.at(0).find("pressed"), std::string::npos);
}

TEST(ImpactWindow, LeavesOutWhatHasTooFewSamples) {
  const auto scene = window(0.3);
  const auto full = reduced::simulate(scene).response;
  Response sparse;
  for (std::size_t i = 0; i < full.size(); i += 40)
    for (const auto &[name, values] : full.all()) sparse.append(name, values[i]);
  const StoredRun run = make_run("sparse", scene, sparse, {});
  EXPECT_TRUE(run.impacts.empty());
  ASSERT_EQ(run.notes.size(), 1u);
  EXPECT_NE(run.notes[0].find("smaller step"), std::string::npos);
}

TEST(ImpactWindow, OptionsNameValueAndBound) {
  try {
    WindowOptions{.tail = -1}.validate();
    FAIL();
  } catch (const InputError &error) {
    EXPECT_EQ(std::string(error.what()), "tail -1 must be > 0 s");
  }
}

} // namespace
} // namespace rimpact::calibration
