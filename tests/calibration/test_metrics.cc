#include "calibration/data/metrics.h"
#include "io/files/error.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {

/// A triangular impact of peak `force` between 1 and 3 s, travel held at `u`, speeds +v before and -rebound
/// after.
Response triangle(double force, double u, double rebound, double dt, double end = 5) {
  Response r;
  const int n = static_cast<int>(std::lround(end / dt));
  for (int i = 0; i <= n; ++i) {
    const double t = i * dt, pressed = std::max(0.0, 1 - std::abs(t - 2));
    r.append("time", t);
    r.append("displacement_x", u);
    r.append("displacement_y", 0);
    r.append("displacement_z", 0);
    r.append("velocity_x", t < 2 ? 0.2 : -rebound);
    r.append("velocity_y", 0);
    r.append("velocity_z", 0);
    r.append("impact_x", -force * pressed);
    r.append("impact_y", 0);
    r.append("force_x", -force * pressed - 10);
    r.append("force_y", 0);
    r.append("force_z", 0);
    r.append("gap", 0.4 - u);
  }
  return r;
}

TEST(Metrics, AgreeWithHandComputedValues) {
  const double dt = 0.01;
  const auto reference = triangle(1000, 0.40, 0.10, dt), candidate = triangle(1200, 0.41, 0.08, dt);
  const auto c = compare(reference, candidate, 0.4);
  EXPECT_NEAR(*c.peak_force_error, 0.2, 1e-12);
  EXPECT_NEAR(*c.peak_displacement_error, 0.025, 1e-12);
  EXPECT_NEAR(*c.rebound_error, -0.2, 1e-12);
  EXPECT_NEAR(*c.nrmse_displacement, 0.01 / 0.4, 1e-12);
  // force difference 200 N x triangle on [1, 3]; its square integrates to 2/3. Span: first non-zero sample
  // (1.01 s) to 0.5 s after the release, where the force's last samples point to (3 s)
  const double span = 3.0 + 0.5 - 1.01, missing = std::pow(0.01, 3) / 3;
  EXPECT_NEAR(*c.nrmse_force, std::sqrt(200 * 200 * (2.0 / 3 - missing) / span) / 1000, 1e-6);
  EXPECT_NEAR(*c.touch_time_difference, 0, 1e-12);
}

/// A quicker approach returns quicker by the same law: the rebound's error and that of rebound over approach differ by
/// it, and all three are told apart.
TEST(Metrics, TellTheSpeedsOfApproachAndReboundAndTheirRatioApart) {
  const auto reference = triangle(1000, 0.40, 0.10, 0.01);
  auto candidate = triangle(1000, 0.40, 0.0997, 0.01);
  for (auto &v : candidate.series("velocity_x"))
    if (v > 0) v *= 1.014;
  const auto c = compare(reference, candidate, 0.4);
  EXPECT_NEAR(*c.approach_speed_error, 0.014, 1e-12);
  EXPECT_NEAR(*c.rebound_error, -0.003, 1e-12);
  EXPECT_NEAR(*c.restitution_error, 0.997 / 1.014 - 1, 1e-12);
  const auto json = to_json(c);
  for (const char *key : {"approach_speed_error", "rebound_error", "restitution_error"})
    EXPECT_TRUE(json.at(key).is_number()) << key;
}

TEST(Metrics, DoNotDependOnTheSampling) {
  const auto reference = triangle(1000, 0.40, 0.10, 0.01);
  const auto fine = compare(reference, triangle(1200, 0.41, 0.08, 0.01), 0.4);
  const auto coarse = compare(reference, triangle(1200, 0.41, 0.08, 0.25), 0.4);
  EXPECT_NEAR(*fine.nrmse_force, *coarse.nrmse_force, 1e-9); // a triangle is linear on both grids
}

// one motion, stored at 10 ms and at 0.6 s: what differs is the straight lines between the samples, and is called so
TEST(Metrics, SayWhatSamplingMakesOfOneMotion) {
  const auto wave = [](double dt) {
    Response r;
    for (double t = 0; t <= 12; t += dt) {
      r.append("time", t);
      for (const char *name : {"displacement_y", "impact_x", "impact_y", "force_x", "force_y"}) r.append(name, 0);
      r.append("displacement_x", 0.2 * std::sin(2 * M_PI * t / 3)), r.append("gap", 0.2);
    }
    return r;
  };
  const auto coarse = compare(wave(0.01), wave(0.6), 0.4);
  ASSERT_EQ(coarse.notes.size(), 2u); // no impact to compare, and
  EXPECT_NE(coarse.notes[1].find("the candidate has a sample every 600 ms on average"), std::string::npos);
  EXPECT_NE(coarse.notes[1].find("make 100 % of the displacement's difference"), std::string::npos) << coarse.notes[1];
  EXPECT_EQ(compare(wave(0.01), wave(0.012), 0.4).notes.size(), 1u);
}

TEST(Metrics, OfAResponseWithItselfAreZero) {
  const auto r = triangle(1000, 0.40, 0.10, 0.01);
  const auto c = compare(r, r, 0.4);
  EXPECT_EQ(*c.peak_force_error, 0);
  EXPECT_EQ(*c.rebound_error, 0);
  EXPECT_EQ(*c.nrmse_displacement, 0);
  EXPECT_EQ(*c.nrmse_force, 0);
  EXPECT_TRUE(c.notes.empty());
}

TEST(Metrics, WithoutAnImpactAreNullWithASentence) {
  const auto none = triangle(0, 0.30, 0.10, 0.01), some = triangle(1000, 0.40, 0.10, 0.01);
  const auto c = compare(none, some, 0.4);
  EXPECT_FALSE(c.peak_force_error);
  EXPECT_FALSE(c.rebound_error);
  EXPECT_FALSE(c.nrmse_force);
  EXPECT_TRUE(c.nrmse_displacement);
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("reference never touches"), std::string::npos);
  EXPECT_TRUE(to_json(c)["peak_force_error"].is_null());

  const auto missed = compare(some, none, 0.4);
  EXPECT_EQ(*missed.peak_force_error, -1);
  EXPECT_FALSE(missed.rebound_error);
  EXPECT_FALSE(missed.notes.empty());
}

TEST(Metrics, RefuseWhatCannotBeCompared) {
  const auto r = triangle(1000, 0.40, 0.10, 0.01);
  EXPECT_THROW(compare(r, r, 0.0), InputError);
  auto later = r;
  for (double &t : later.series("time")) t += 100;
  EXPECT_THROW(compare(r, later, 0.4), DataError);
}

} // namespace
} // namespace rimpact::calibration
