// A rim's curve at speed against the similarity it is made by, and what is refused.
#include "fe_contact/drive/fast_curve.h"
#include "io/files/error.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

constexpr double stiffness = 1e9, mass = 80e3;

/// F = sqrt(2 a k d), a = 1 kN, unloaded straight with the stiffness; strains of 10 per metre.
reduced::RimCurveFile slow_curve() {
  reduced::RimCurveFile file;
  const auto force = [](double d) { return std::sqrt(2e3 * stiffness * d); };
  for (int i = 0; i <= 40; ++i) {
    const double d = 0.02 * i * i / 1600;
    file.held.loading.penetration.push_back(d), file.held.loading.force.push_back(force(d));
    if (i > 0) file.strain.penetration.push_back(d), file.strain.strain.push_back(10 * d);
  }
  for (const int i : {10, 25, 40}) {
    const double D = 0.02 * i * i / 1600, top = force(D);
    laws::CurveSamples back;
    for (int k = 0; k <= 4; ++k)
      back.penetration.push_back(D - top / stiffness * k / 4), back.force.push_back(top * (4 - k) / 4);
    file.held.unloading.push_back(back);
  }
  return file;
}

scene::Bearing fast_steel(scene::RateModel model = scene::RateModel::cowper_symonds) {
  scene::Bearing bearing;
  bearing.steel.rate.model = model;
  return bearing;
}

TEST(FastCurve, TheFactorIsThatOfTheRateAndTheCurveIsSimilar) {
  const auto slow = slow_curve();
  for (const double speed : {0.05, 0.2}) {
    const FastCurve fast = fast_curve(slow, fast_steel(), mass, speed);
    EXPECT_NEAR(fast.rate, 10 * speed, 1e-6 * speed);
    EXPECT_NEAR(fast.factor, 1 + std::pow(fast.rate / 40, 0.2), 1e-12);
    const laws::RimCurve a(slow.held), b(fast.file.held);
    const double s = fast.factor;
    for (const double d : {0.001, 0.004, 0.012}) {
      EXPECT_NEAR(b.loading(s * d).force / (s * a.loading(d).force), 1, 1e-9);
      EXPECT_NEAR(b.loading(s * d).slope / a.loading(d).slope, 1, 1e-9) << "the stiffness is the same";
      EXPECT_NEAR(b.work(s * d) / (s * s * a.work(d)), 1, 1e-9);
      EXPECT_NEAR(b.returned(s * d) / (s * s * a.returned(d)), 1, 1e-9);
      EXPECT_NEAR(b.residual(s * d) / (s * a.residual(d)), 1, 1e-9);
    }
  }
  const FastCurve cook = fast_curve(slow, fast_steel(scene::RateModel::johnson_cook), mass, 0.05);
  EXPECT_EQ(cook.factor, 1) << "0.5 1/s is below the reference of 1 1/s";
}

TEST(FastCurve, TheRimsOwnSteelCounts) {
  scene::Bearing bearing = fast_steel();
  bearing.part_steels.emplace(scene::SteelPart::rim, bearing.steel).first->second.rate.D = 4000;
  EXPECT_NEAR(fast_curve(slow_curve(), bearing, mass, 0.1).factor, 1 + std::pow(1.0 / 4000, 0.2), 1e-6);
}

TEST(FastCurve, WhatItCannotKnowIsRefused) {
  auto slow = slow_curve();
  EXPECT_THROW(fast_curve(slow, scene::Bearing{}, mass, 0.2), InputError) << "no rate";
  EXPECT_THROW(fast_curve(slow, fast_steel(), mass, 5.0), InputError) << "too fast for the curve";
  slow.strain = {};
  EXPECT_THROW(fast_curve(slow, fast_steel(), mass, 0.2), InputError) << "no strain";
}

} // namespace
} // namespace rimpact::fe
