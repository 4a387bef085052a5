#include "io/records/spectral_acceleration.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace rimpact;
using std::numbers::pi;

// A constant acceleration held for ever: u = -a/w^2 (1 - e^(-xi w t) (...)), overshoot 1 + exp(-xi pi /
// sqrt(1 - xi^2)).
TEST(SpectralAcceleration, StepOvershoots) {
  SampledSignal step{0.01, std::vector<double>(301, 2.0)};
  EXPECT_NEAR(spectral_acceleration(step, 1.0, 0.05), 2 * (1 + std::exp(-0.05 * pi / std::sqrt(1 - 0.0025))), 1e-3);
  EXPECT_NEAR(spectral_acceleration(step, 1.0, 0.0), 4, 2e-3);
}

// The free vibration after a short push: S_a = w dv for an impulse dv.
TEST(SpectralAcceleration, ImpulseIsSeenAfterItsEnd) {
  SampledSignal push{0.001, {0, 1, 0}};
  EXPECT_NEAR(spectral_acceleration(push, 2.0, 0.0), 2 * pi / 2.0 * 1e-3, 1e-6);
}

// Steady resonance: S_a = a / (2 xi). A coarse record of the same sine is integrated exactly between its
// samples.
TEST(SpectralAcceleration, Resonance) {
  SampledSignal fine{0.005, {}};
  for (int i = 0; i <= 12000; ++i) fine.values.push_back(std::sin(2 * pi * i * 0.005));
  EXPECT_NEAR(spectral_acceleration(fine, 1.0, 0.05), 10, 1e-2);
  EXPECT_NEAR(spectral_acceleration(fine, 0.02, 0.05), 1, 1e-2); // stiff: rides along
}

// Refining the samples of one and the same piecewise linear record changes nothing but where peaks are looked
// for.
TEST(SpectralAcceleration, ExactBetweenSamples) {
  SampledSignal coarse{0.05, {0, 1, -0.4, 2, 0.3, -1, 0}}, refined{0.01, {}};
  for (int i = 0; i <= 30; ++i) refined.values.push_back(coarse.at(0.01 * i));
  for (const double period : {0.3, 1.0, 3.0})
    EXPECT_NEAR(spectral_acceleration(refined, period) / spectral_acceleration(coarse, period), 1, 1e-3);
  EXPECT_EQ(spectral_acceleration({}, 1.0), 0);
}
