// The examples of docs/extending.md do what they say.
#include "extending_examples.h"
#include <gtest/gtest.h>

TEST(Extending, TheLawsDerivativeIsItsOwn) {
  RimElement rim;
  rim.stiffness = 1e9, rim.law = &line;
  const double d = 3e-3, h = 1e-8;
  const double slope = (rim.at({.d = d + h, .rate = 0}).force - rim.at({.d = d - h, .rate = 0}).force) / (2 * h);
  EXPECT_NEAR(rim.at({.d = d, .rate = 0}).d_penetration, slope, 1e-6 * slope);
  EXPECT_DOUBLE_EQ(rim.at({.d = d, .rate = 0}).force, 1e9 * d * 1.3);
}

TEST(Extending, ASceneIsFlown) {
  const double slow = peak_force(0.1), fast = peak_force(0.3);
  EXPECT_NEAR(fast / slow, 3, 1e-3); // a linear spring and dashpot
}
