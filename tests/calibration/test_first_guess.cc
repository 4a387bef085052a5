#include "calibration/fit/first_guess.h"
#include "calibration/fit/fit.h"
#include "measured_synthetic.h"
#include "synthetic.h"
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

constexpr double stiffness = 9.2e8, yield = 0.64e6, tangent = 0.17, gain = 0.42;

scene::Scene yielding(double speed, const std::string &law = "elastoplastic") {
  auto s = window(speed, stiffness);
  s.reduced.impact_law = &laws::impact_law(law);
  s.reduced.yield_force = yield, s.reduced.hardening = tangent, s.reduced.unloading_gain = gain;
  return s;
}

TEST(FirstGuess, ReadsABilinearCurve) {
  const StoredRun run = run_of(yielding(0.4, "bilinear"));
  const auto curve = read_curve(run.impacts.at(0));
  ASSERT_TRUE(curve);
  EXPECT_NEAR(curve->initial / stiffness, 1, 1e-3);
  EXPECT_NEAR(curve->tangent / stiffness, tangent, 1e-3 * tangent);
  EXPECT_NEAR(curve->unloading / stiffness, 1, 1e-3);
  EXPECT_NEAR(curve->intercept(), (1 - tangent) * yield, 1e-2 * yield);
}

TEST(FirstGuess, ASmoothKneeIsReadNearItsNumbers) {
  const StoredRun run = run_of(yielding(0.4));
  const auto guess = first_guess(yielding(0.4), {&run.impacts.at(0)}).reduced;
  EXPECT_NEAR(guess.k_i / stiffness, 1, 0.25);
  EXPECT_NEAR(guess.yield_force / yield, 1, 0.3);
  EXPECT_NEAR(guess.hardening / tangent, 1, 0.5);
}

TEST(FirstGuess, ACurveOfTooFewSamplesIsNone) {
  ImpactWindow w = run_of(yielding(0.4)).impacts.at(0);
  w.times.resize(3), w.displacement.resize(3), w.force.resize(3);
  EXPECT_FALSE(read_curve(w));
}

// 2 kHz, 2 % of the force, one impact: one of four such fits ended at a bound, far from the truth
TEST(FirstGuess, NoiseLeadsIntoNoFalseMinimum) {
  FitOptions options;
  options.law = "elastoplastic", options.parameters = laws::impact_law("elastoplastic").parameters;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    StoredRun run =
        measured(yielding(0.4), {.rate = 2000, .displacement = 0.02e-3, .force = 0.02, .before = 0.02}, seed);
    run.scene.reduced = {};
    const auto found = fit({&run}, options).parameters;
    EXPECT_NEAR(found.at("k_i").value / (stiffness / 1e3), 1, 0.25) << seed;
    EXPECT_NEAR(found.at("yield_force").value / (yield / 1e3), 1, 0.2) << seed;
    EXPECT_NEAR(found.at("hardening").value / tangent, 1, 0.25) << seed;
    EXPECT_FALSE(found.at("hardening").at_bound) << seed;
  }
}

} // namespace
} // namespace rimpact::calibration
