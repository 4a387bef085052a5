#include "io/files/error.h"
#include "studies/reliability/hazard.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace rimpact;
using namespace rimpact::reliability;

namespace {

std::string refusal(std::vector<HazardPoint> points) {
  try {
    HazardCurve curve(std::move(points));
  } catch (const InputError &error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST(HazardCurve, PassesThroughItsPoints) {
  const HazardCurve curve({{0.1, 43}, {0.2, 475}, {0.5, 2475}});
  EXPECT_DOUBLE_EQ(curve.rate(0.1), 1 / 43.0);
  EXPECT_DOUBLE_EQ(curve.rate(0.2), 1 / 475.0);
  EXPECT_NEAR(curve.rate(0.5) * 2475, 1, 1e-14);
}

TEST(HazardCurve, IsAPowerLawBetweenAndBeyondItsPoints) {
  const auto law = [](double x) { return 3e-5 * std::pow(x, -2.3); };
  std::vector<HazardPoint> points;
  for (const double x : {0.05, 0.2, 0.9}) points.push_back({x, 1 / law(x)});
  const HazardCurve curve(points);
  for (const double x : {0.001, 0.07, 0.2, 0.4, 0.9, 30.0}) {
    EXPECT_NEAR(curve.rate(x) / law(x), 1, 1e-12) << x;
    EXPECT_NEAR(curve.slope(x), 2.3, 1e-12) << x;
  }
}

TEST(HazardCurve, GoesDownContinuouslyWhereTheSlopeChanges) {
  const HazardCurve curve({{0.1, 50}, {0.2, 500}, {0.5, 600}});
  EXPECT_NEAR(curve.rate(0.2 * (1 - 1e-12)) / curve.rate(0.2), 1, 1e-10);
  EXPECT_GT(curve.slope(0.19), curve.slope(0.2));
}

TEST(HazardCurve, RefusesACliff) {
  EXPECT_EQ(refusal({{0.3, 475}, {0.30001, 2475}}),
            "the hazard curve falls as intensity^-4.95e+04 between points 1 and "
            "2; 100 is the steepest a ground can have");
  EXPECT_NE(refusal({{0.4, 1e-300}, {0.8, 1e300}}).find("the steepest"), std::string::npos);
}

TEST(HazardCurve, RefusesWhatIsNotMonotone) {
  EXPECT_EQ(refusal({{0.1, 43}, {0.2, 475}, {0.15, 2475}}),
            "the hazard curve is not monotone: intensity 0.15 of point 3 does not exceed 0.2 of point 2");
  EXPECT_EQ(refusal({{0.1, 43}, {0.2, 43}}),
            "the hazard curve is not monotone: return period 43 of point 2 does not exceed 43 of point 1");
  EXPECT_EQ(refusal({{0.1, 43}, {0.1, 475}}),
            "the hazard curve is not monotone: intensity 0.1 of point 2 does not exceed 0.1 of point 1");
  EXPECT_EQ(refusal({{0.1, 43}}), "a hazard curve needs at least 2 points, not 1");
  EXPECT_EQ(refusal({{0, 43}, {0.2, 475}}), "hazard point (0, 43 years): both numbers must be finite and > 0");
  EXPECT_NE(refusal({{0.1, 43}, {0.2, std::numeric_limits<double>::infinity()}}), "accepted");
  EXPECT_THROW(HazardCurve({{0.1, 43}, {0.2, 475}}).rate(0), InputError);
}
