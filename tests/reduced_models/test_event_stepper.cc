// Which of several events ends a step, and when.
#include "reduced_models/motion/event_stepper.h"

#include <functional>
#include <gtest/gtest.h>

namespace rimpact::reduced {
namespace {

/// A clock: y' = 1. Watches are functions of the time since the step's start.
struct Clock {
  using Vector = std::vector<double>;
  using Watch = std::function<double(double)>;
  double start = 0;

  void rhs(double, const Vector &, Vector &dy) { dy.assign(1, 1.0); }
  double value(const Watch &watch, double t, const Vector &) const { return watch(t - start); }
  double value_at_end(const Watch &watch, const DormandPrince<Vector> &step) const {
    return watch(step.t + step.h - start);
  }
  bool begins_at_zero(const Watch &) const { return true; }
  double largest_step() const { return 1; }
  void give_up(double, const Vector &) const {}
};

/// Place of the event that ends a step of one second, and its time in it.
std::pair<int, double> first(const std::vector<Clock::Watch> &events) {
  static const std::vector<double> no_breaks;
  Clock clock;
  EventStepper<Clock> stepper(clock);
  stepper.begin(0, {0.0}, {1.0}, no_breaks);
  auto &step = stepper.step;
  clock.rhs(0, step.y0, step.k[0]);
  while (step.h < 1) { // steps grow to the longest
    stepper.advance(std::vector<Clock::Watch>{}, 100);
    stepper.move_on(step.y1);
    step.k[0] = step.k[6];
  }
  clock.start = step.t;
  const int place = stepper.advance(events, 100);
  return {place, step.h};
}

double late(double t) {
  return 0.7 - t;
}
double early(double t) {
  return 100 * (0.5 - t) * (1.2 - t); // the first, and not the lowest at the end
}
double between(double t) {
  return (t - 0.2) * (t - 0.4); // above zero again at the step's end
}

} // namespace

TEST(EventStepper, WithoutAnEventTheStepIsWhole) {
  EXPECT_EQ(first({[](double) { return 1.0; }}), std::make_pair(-1, 1.0));
}

TEST(EventStepper, TheFirstOfSeveralEndsTheStep) {
  for (const auto &[events, due] : std::vector<std::pair<std::vector<Clock::Watch>, int>>{
           {{late, early}, 1}, {{early, late}, 0}, {{early, early, late}, 0}}) {
    const auto [place, h] = first(events);
    EXPECT_EQ(place, due);
    EXPECT_NEAR(h, 0.5, 1e-14);
  }
}

TEST(EventStepper, WhatHasFallenAtTheShortenedEndIsFoundToo) {
  const auto [place, h] = first({[](double t) { return 0.3 - t; }, between});
  EXPECT_EQ(place, 1);
  EXPECT_NEAR(h, 0.2, 1e-14);
}

TEST(EventStepper, WhatHasFallenAtTheStartEndsTheStepThere) {
  const auto [place, h] = first({late, [](double t) { return -t; }, early});
  EXPECT_EQ(place, 1);
  EXPECT_EQ(h, 0);
}

TEST(EventStepper, AZeroAtTheStartThatIsLeftUpwardsIsNone) {
  const auto [place, h] = first({[](double t) { return t * (0.9 - t); }, late});
  EXPECT_EQ(place, 1);
  EXPECT_NEAR(h, 0.7, 1e-14);
}

} // namespace rimpact::reduced
