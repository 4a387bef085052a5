// Curves of the flow stress: closed forms, and a table that agrees with the law it was taken from.
#include "fe_contact/laws/hardening.h"

#include "steels.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::fe {
namespace {

using test::steel_with;

constexpr double curve_strains[] = {1e-6, 1e-3, 0.01, 0.05, 0.2, 0.7};

TEST(Hardening, LawsAreThoseOfTheirFormulas) {
  const Hardening swift(test::swift()), voce(test::voce()), ludwik(test::ludwik());
  for (const double a : curve_strains) {
    EXPECT_DOUBLE_EQ(swift.stress(a), 800e6 * std::pow(0.01 + a, 0.2));
    EXPECT_DOUBLE_EQ(voce.stress(a), 360e6 + 200e6 * (1 - std::exp(-15 * a)));
    EXPECT_DOUBLE_EQ(ludwik.stress(a), 360e6 + 700e6 * std::pow(a, 0.6));
  }
  EXPECT_DOUBLE_EQ(voce.stress(0), 360e6);
  EXPECT_DOUBLE_EQ(ludwik.stress(0), 360e6);
  EXPECT_TRUE(std::isinf(ludwik.slope(0)));
}

TEST(Hardening, SlopeAndWorkAreDerivativeAndIntegral) {
  for (const auto &[name, material] : test::steels()) {
    const Hardening curve(material);
    double sum = 0, before = 0;
    EXPECT_NEAR(curve.work(0), 0, 1e-6) << name;
    for (const double a : curve_strains) {
      const double h = 1e-4 * a;
      const double difference = (curve.stress(a + h) - curve.stress(a - h)) / (2 * h);
      EXPECT_NEAR(curve.slope(a), difference, 1e-6 * difference + 1e4) << name << a; // rounding: 500 Pa at 1e-6
      constexpr int n = 20000; // midpoints, denser towards the start
      for (int k = 0; k < n; ++k) {
        const auto at = [&](double s) { return before + (a - before) * s * s * s; };
        const double from = at(double(k) / n), to = at(double(k + 1) / n);
        sum += (to - from) * curve.stress((from + to) / 2);
      }
      before = a;
      EXPECT_NEAR(curve.work(a) / sum, 1, 1e-6) << name << a;
    }
  }
}

TEST(Hardening, ATableIsStraightBetweenItsRowsAndHeldBeyond) {
  const Hardening table(test::table());
  EXPECT_DOUBLE_EQ(table.stress(0), 360e6);
  EXPECT_DOUBLE_EQ(table.stress(0.01), 360e6); // a plateau
  EXPECT_DOUBLE_EQ(table.stress(0.06), 440e6);
  EXPECT_DOUBLE_EQ(table.stress(0.10), 520e6);
  EXPECT_DOUBLE_EQ(table.stress(1.0), 560e6);
  EXPECT_EQ(table.slope(1.0), 0);
  EXPECT_DOUBLE_EQ(table.slope(0.05), 2e9);
  EXPECT_DOUBLE_EQ(table.work(1.0), 0.02 * 360e6 + 0.08 * 440e6 + 0.4 * 540e6 + 0.5 * 560e6);
}

TEST(Hardening, ATableOfManyRowsIsTheLawItWasTakenFrom) {
  const Hardening voce(test::voce());
  scene::Material rows = steel_with(scene::HardeningLaw::table);
  for (int k = 0; k <= 800; ++k) rows.hardening.curve.values.push_back({k / 1000.0, voce.stress(k / 1000.0)});
  const Hardening table(rows);
  for (const double a : curve_strains) {
    EXPECT_NEAR(table.stress(a) / voce.stress(a), 1, 2e-5);
    EXPECT_NEAR(table.work(a) / voce.work(a), 1, 2e-5);
  }
}

} // namespace
} // namespace rimpact::fe
