#include "calibration/data/impact_window.h"
#include "calibration/data/pulse.h"
#include "calibration/data/series.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace rimpact::calibration {
namespace {

TEST(Series, HermiteIsExactForCubics) {
  const auto f = [](double t) { return 1 + t - 2 * t * t + 0.5 * t * t * t; };
  const auto df = [](double t) { return 1 - 4 * t + 1.5 * t * t; };
  const std::vector<double> times = {0, 0.7, 1.1, 3};
  std::vector<double> values, rates;
  for (const double t : times) values.push_back(f(t)), rates.push_back(df(t));
  for (const double t : {0.1, 0.7, 0.9, 2.2, 3.0}) EXPECT_NEAR(hermite_at(times, values, rates, t), f(t), 1e-13);
}

TEST(Series, PulseIsCubicInsideAndZeroOutside) {
  const auto f = [](double t) { return 2 + t * t * t; };
  std::vector<double> times, values;
  for (int i = 0; i <= 20; ++i) {
    times.push_back(0.1 * i);
    values.push_back(i >= 5 && i <= 12 ? f(times.back()) : 0);
  }
  for (const double t : {0.5, 0.53, 0.77, 1.15, 1.2}) EXPECT_NEAR(pulse_at(times, values, t), f(t), 1e-12) << t;
  for (const double t : {0.1, 0.4, 1.3, 1.9, -1.0, 5.0}) EXPECT_EQ(pulse_at(times, values, t), 0) << t;
}

// a force that rises from nothing at touch and falls to nothing at release, sampled as the model steps
TEST(Series, APulseHasItsFirstAndLastInterval) {
  const auto f = [](double t) { return t > 0.13 && t < 0.9 ? (t - 0.13) * (0.9 - t) : 0; };
  const std::vector<double> times = {0, 0.13, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 1};
  std::vector<double> values;
  for (const double t : times) values.push_back(f(t));
  for (const double t : {0.131, 0.17, 0.6, 0.82, 0.899}) EXPECT_NEAR(pulse_at(times, values, t), f(t), 1e-14) << t;
  for (const double t : {0.05, 0.95}) EXPECT_EQ(pulse_at(times, values, t), 0) << t;
}

// coarse samples tell little of an end: the force neither pulls there nor exceeds its neighbour
TEST(Series, TheEndOfAPulseDoesNotOvershoot) {
  const std::vector<double> times = {0, 1, 2, 3, 4}, values = {252, 115, 5, 0, 0};
  for (double t = 2; t <= 3; t += 0.05) {
    EXPECT_GE(pulse_at(times, values, t), 0) << t;
    EXPECT_LE(pulse_at(times, values, t), 5) << t;
  }
}

// decision 5: a release that passes an instant moves the value there by nothing
TEST(Series, NothingJumpsWhereAReleasePassesAnInstant) {
  const auto at = [](double release) {
    const auto f = [&](double t) { return std::max(0.0, release - t); };
    std::vector<double> times, values;
    for (int i = 0; i < 20; ++i) times.push_back(0.1 * i);
    times.insert(std::upper_bound(times.begin(), times.end(), release), release);
    for (const double t : times) values.push_back(f(t));
    return pulse_at(times, values, 1.03);
  };
  for (double release = 0.9; release < 1.2; release += 1e-3)
    EXPECT_NEAR(at(release), std::max(0.0, release - 1.03), 1e-12) << release;
}

TEST(Series, PulseKeepsToOneSideOfAStoredJump) {
  const std::vector<double> times = {0, 1, 1, 2, 3, 3, 4}, values = {0, 0, 5, 6, 7, 0, 0};
  EXPECT_NEAR(pulse_at(times, values, 1.0), 5, 1e-12);
  EXPECT_NEAR(pulse_at(times, values, 2.5), 6.5, 1e-12);
  EXPECT_EQ(pulse_at(times, values, 0.999), 0);
  EXPECT_EQ(pulse_at(times, values, 3.5), 0);
}

TEST(Series, DifferencesAreExactForParabolas) {
  const std::vector<double> times = {0, 0.3, 0.4, 1.0, 1.7};
  std::vector<double> values;
  for (const double t : times) values.push_back(3 * t * t - t);
  const auto rates = differentiate(times, values);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(rates[i], 6 * times[i] - 1, 1e-12);
}

TEST(SmoothPeak, FindsThePeakBetweenSamplesAndThroughNoise) {
  std::vector<double> times, force, noisy;
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0, 0.01);
  for (int i = 0; i < 101; ++i) {
    times.push_back(1e-3 * (i + 0.37));
    force.push_back(std::max(0.0, std::sin(M_PI * times.back() / 0.1)));
    noisy.push_back(force.back() + noise(generator));
  }
  EXPECT_NEAR(smooth_peak(times, force), 1, 1e-4);
  EXPECT_NEAR(smooth_peak(times, noisy), 1, 0.006);
  EXPECT_GT(*std::max_element(noisy.begin(), noisy.end()), 1.01); // what the largest sample would have said
}

TEST(SmoothPeak, AtTheEdgeOfAPulse) {
  std::vector<double> times, force;
  for (int i = 0; i < 50; ++i) times.push_back(0.01 * i), force.push_back(10 * std::exp(-times.back()));
  EXPECT_NEAR(smooth_peak(times, force), 10, 1e-4);
  EXPECT_EQ(smooth_peak({0, 1}, {0, 0}), 0);
  EXPECT_EQ(smooth_peak({0, 1, 2}, {0, 3, 0}), 3);
}

} // namespace
} // namespace rimpact::calibration
