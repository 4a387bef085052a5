// When a step is taken, made shorter, or taken although its error did not fall.
#include "fe_contact/drive/step_control.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

using namespace rimpact::fe;

namespace {

constexpr StepControl control{.most_error = 4, .least_cut = 0.25, .most_growth = 1.6, .most_of_a_jump = 20};
constexpr double dt = 1e-3;

/// Steps are tried from one start until one is taken: its length over the first one's.
double taken(const StepControl &rule, const std::function<double(double)> &error_of, double shortest) {
  double step = dt, refused = 0;
  for (int k = 0; k < 100; ++k) {
    const Attempt attempt = rule.assess(error_of(step), step, step > shortest, false, refused);
    if (attempt.accepted) return step / dt;
    EXPECT_LT(attempt.suggested_step, step);
    refused = attempt.error, step = attempt.suggested_step;
  }
  ADD_FAILURE() << "no step was taken";
  return 0;
}

} // namespace

TEST(StepControl, AnErrorOfTheStepIsCutUntilItIsSmall) {
  const auto cubic = [](double step) { return 50 * std::pow(step / dt, 3); };
  const double share = taken(control, cubic, dt / 1000);
  EXPECT_LE(cubic(share * dt), control.most_error);
  EXPECT_GT(share, 0.1);
}

TEST(StepControl, AJumpIsTakenAfterOneCut) {
  const auto jump = [](double step) { return 6 + 0.5 * step / dt; }; // what no step, however short, would lower
  EXPECT_GE(taken(control, jump, dt / 1000), control.least_cut);
  EXPECT_LE(taken({.most_error = 4, .least_cut = 0.25}, jump, dt / 1000), 2e-3); // without the rule: to the shortest
}

TEST(StepControl, ALargeJumpIsNotTaken) {
  const auto large = [](double) { return 1.01 * control.most_of_a_jump; };
  EXPECT_LE(taken(control, large, dt / 1000), 2e-3);
}

TEST(StepControl, AnErrorThatGrowsWithShorterStepsIsNoJump) {
  const auto growing = [](double step) { return 5 * std::pow(dt / step, 0.6); };
  EXPECT_LE(taken(control, growing, dt / 1000), 2e-3);
}
