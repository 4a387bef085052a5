// The degrading law: closed forms, tangents, energies; against an independent integration degrading_bouc_wen.py.
#include "buildings/degrading_bouc_wen.h"
#include <cmath>
#include <gtest/gtest.h>

using rimpact::buildings::DegradingBoucWen;
using Point = DegradingBoucWen::Point;

namespace {

const DegradingBoucWen degrading{.yield_force = 300,
                                 .yield_deformation = 0.004,
                                 .post_yield = 0.03,
                                 .exponent = 1.7,
                                 .beta = 0.6,
                                 .strength_loss = 0.05,
                                 .stiffness_loss = 0.1};

/// Classical Runge-Kutta of the rates under d(t), `n` steps to t = `end`.
template <class Path> Point integrate(const DegradingBoucWen &law, Path d, double end, int n) {
  Point p{d(0), 0, 0};
  const double h = end / n;
  const auto speed = [&](double t) { return (d(t + 1e-6) - d(t - 1e-6)) / 2e-6; };
  const auto moved = [](const Point &from, double h, const Point &rate) {
    return Point{from.d + h * rate.d, from.z + h * rate.z, from.e + h * rate.e};
  };
  for (int i = 0; i < n; ++i) {
    const double t = i * h;
    const Point k1 = law.rates(p, speed(t)), k2 = law.rates(moved(p, h / 2, k1), speed(t + h / 2)),
                k3 = law.rates(moved(p, h / 2, k2), speed(t + h / 2)), k4 = law.rates(moved(p, h, k3), speed(t + h));
    p = {d(t + h), p.z + h / 6 * (k1.z + 2 * k2.z + 2 * k3.z + k4.z),
         p.e + h / 6 * (k1.e + 2 * k2.e + 2 * k3.e + k4.e)};
  }
  return p;
}

} // namespace

TEST(DegradingBoucWen, FromRestIsTheHyperbolicTangent) {
  const DegradingBoucWen law{.yield_force = 2, .yield_deformation = 0.5};
  for (const double d : {0.1, 0.5, 1.3, -0.8}) {
    const Point p = integrate(
        law, [&](double t) { return d * t; }, 1, 2000);
    EXPECT_NEAR(p.z, std::tanh(d / 0.5), 1e-9);
    EXPECT_NEAR(law.force(p), 0.02 * 4 * d + 0.98 * 2 * std::tanh(d / 0.5), 1e-8);
  }
}

TEST(DegradingBoucWen, ImplicitStepsConvergeToTheRates) {
  const auto path = [](double t) { return 0.02 * std::sin(3 * t) * (1 + t); };
  const Point exact = integrate(degrading, path, 4, 200000);
  EXPECT_GT(exact.e, 10);
  double before = 0;
  for (const int n : {2000, 4000, 8000}) {
    Point p{};
    for (int i = 1; i <= n; ++i) p = degrading.implicit_step(p, path(4.0 * i / n), p).at;
    const double error = std::abs(p.z - exact.z) + std::abs(p.e - exact.e);
    if (before > 0) {
      EXPECT_NEAR(before / error, 2, 0.2); // backward Euler
    }
    before = error;
  }
}

TEST(DegradingBoucWen, TangentIsThatOfTheStage) {
  for (const Point base : {Point{0.001, 0.2, 0}, Point{-0.01, -0.8, 12}, Point{0.002, 0, 3}, Point{0, 0.9, 0.1}})
    for (const double by : {1e-5, 2e-3, -4e-3, 0.05, -0.05}) {
      const double d = base.d + by, h = 1e-7 * degrading.yield_deformation;
      const auto at = degrading.implicit_step(base, d, base);
      ASSERT_TRUE(std::isfinite(at.force));
      const double slope =
          (degrading.implicit_step(base, d + h, at.at).force - degrading.implicit_step(base, d - h, at.at).force) /
          (2 * h);
      EXPECT_NEAR(at.slope, slope, 1e-6 * degrading.stiffness()) << base.z << " " << by;
    }
}

TEST(DegradingBoucWen, LosesEnergyOnlyAndKeepsTheLedger) {
  Point p{};
  double work = 0, lost = 0, strength = 1;
  constexpr int n = 200000;
  for (int i = 1; i <= n; ++i) {
    const double t = 20.0 * i / n, d = 0.03 * std::sin(t) * std::sin(0.7 * t);
    const Point before = p;
    p = degrading.implicit_step(p, d, p).at;
    const Point rates{p.d - before.d, p.z - before.z, p.e - before.e};
    const double loss = degrading.loss(p, rates);
    EXPECT_GE(loss, 0);
    lost += loss, work += 0.5 * (degrading.force(p) + degrading.force(before)) * (p.d - before.d);
    EXPECT_LE(degrading.strength_left(p), strength);
    strength = degrading.strength_left(p);
  }
  EXPECT_GT(lost, 0);
  EXPECT_NEAR(work, lost + degrading.stored(p), 1e-3 * work);
}

TEST(DegradingBoucWen, StrengthAndUnloadingStiffnessAreWhatIsLeft) {
  Point p{};
  for (int i = 1; i <= 40000; ++i) p = degrading.implicit_step(p, 0.04 * std::sin(i * 1e-3), p).at;
  const double e = p.e;
  for (int i = 1; i <= 4000; ++i) p = degrading.implicit_step(p, p.d + 1e-5, p).at; // far in one direction
  EXPECT_NEAR(p.z, degrading.strength_left(p), 5e-3);
  EXPECT_GT(p.e, e);
  const auto back = degrading.rates(p, -1.0); // beta 0.6: unloads a little steeper than 1 / eta
  EXPECT_NEAR(-back.z * degrading.yield_deformation, degrading.stiffness_left(p) * (1 + 0.2), 0.01);
}

TEST(DegradingBoucWen, AnElasticOneIsASpring) {
  const DegradingBoucWen law{.yield_force = 3, .yield_deformation = 0.1, .post_yield = 1};
  const auto step = law.implicit_step({}, 5, {});
  EXPECT_DOUBLE_EQ(step.force, 150);
  EXPECT_DOUBLE_EQ(step.slope, 30);
  EXPECT_DOUBLE_EQ(law.loss(step.at, {1, 1, 1}), 0);
}
