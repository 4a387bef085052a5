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

std::vector<const Parameter *> free_of(const std::string &law) {
  std::vector<const Parameter *> free;
  for (const auto &name : laws::impact_law(law).parameters) free.push_back(&parameter(name));
  return free;
}

TEST(FirstGuess, FindsTheNumbersOfALawThatYieldsByItsForceOverThePath) {
  for (const std::string law : {"bilinear", "elastoplastic"}) {
    const StoredRun run = run_of(yielding(0.4, law));
    auto forgotten = run.scene;
    forgotten.reduced = {}, forgotten.reduced.impact_law = &laws::impact_law(law);
    const auto guess = first_guess(forgotten, {&run.impacts.at(0)}, free_of(law)).reduced;
    EXPECT_NEAR(guess.k_i / stiffness, 1, 0.01) << law; // the deepest instant lies between samples
    EXPECT_NEAR(guess.yield_force / yield, 1, 0.01) << law;
    EXPECT_NEAR(guess.hardening / tangent, 1, 0.01) << law;
    if (law == "bilinear") continue;
    EXPECT_NEAR(guess.unloading_gain / gain, 1, 0.03);
  }
}

TEST(FirstGuess, MovesOnlyWhatIsFree) {
  const StoredRun run = run_of(yielding(0.4));
  auto held = run.scene;
  held.reduced.hardening = 0.05, held.reduced.unloading_gain = 0.1;
  const auto guess = first_guess(held, {&run.impacts.at(0)}, {&parameter("k_i"), &parameter("yield_force")}).reduced;
  EXPECT_EQ(guess.hardening, 0.05);
  EXPECT_EQ(guess.unloading_gain, 0.1);
}

TEST(FirstGuess, FewerSamplesThanNumbersAreNotRead) {
  StoredRun run = run_of(yielding(0.4));
  ImpactWindow &w = run.impacts.at(0);
  w.times.resize(2), w.displacement.resize(2), w.force.resize(2);
  const auto guess = first_guess(run.scene, {&w}, free_of("elastoplastic")).reduced;
  EXPECT_EQ(guess.hardening, run.scene.reduced.hardening);
}

// Two windows of a dozen samples each at 1 kHz: straight lines could not be read off them, and these three of 200 such
// records ended with the yield force at its bound.
TEST(FirstGuess, AFewSamplesLeadIntoNoFalseMinimum) {
  FitOptions options;
  options.law = "elastoplastic", options.parameters = laws::impact_law("elastoplastic").parameters;
  for (const unsigned seed : {21u, 51u, 88u}) {
    std::vector<StoredRun> runs;
    for (const double speed : {0.2, 0.4}) {
      auto s = window(speed, 6e8);
      s.reduced.impact_law = &laws::impact_law("elastoplastic");
      s.reduced.yield_force = 0.6e6, s.reduced.hardening = 0.15, s.reduced.unloading_gain = 0.3;
      const Instruments slow{.rate = 1000, .displacement = 0.02e-3, .force = 0.02, .before = 0.01};
      runs.push_back(measured(s, slow, 100003u * static_cast<unsigned>(runs.size()) + seed));
      runs.back().scene.reduced = {};
    }
    const auto found = fit({&runs[0], &runs[1]}, options);
    EXPECT_TRUE(found.within_noise) << seed;
    EXPECT_NEAR(found.parameters.at("k_i").value / 6e5, 1, 0.06) << seed;
    EXPECT_NEAR(found.parameters.at("yield_force").value / 600, 1, 0.04) << seed;
  }
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
