// Coefficients as pure values: against closed forms, and their derivatives against differences.
#include "io/files/error.h"
#include "laws/friction/factors.h"
#include "laws/friction/friction_law.h"
#include <cmath>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::friction;

namespace {

std::shared_ptr<const FrictionTable> table() {
  return std::make_shared<const FrictionTable>(std::vector<double>{0, 0.1, 1}, std::vector<double>{10e6, 50e6},
                                               std::vector<double>{0.04, 0.03, 0.08, 0.06, 0.09, 0.07});
}

/// Derivatives against central differences, away from kinks.
void expect_consistent(const FrictionLaw &law, const Sliding &s) {
  const auto difference = [&](double Sliding::*member, double step) {
    Sliding low = s, high = s;
    low.*member -= step, high.*member += step;
    return (law.at(high).value - law.at(low).value) / (2 * step);
  };
  const Coefficient mu = law.at(s);
  EXPECT_NEAR(mu.d_speed, difference(&Sliding::speed, 1e-5), 1e-8 + 1e-6 * std::abs(mu.d_speed));
  EXPECT_NEAR(mu.d_pressure, difference(&Sliding::pressure, 1e2), 1e-16 + 1e-6 * std::abs(mu.d_pressure));
  EXPECT_NEAR(mu.d_temperature, difference(&Sliding::temperature, 1e-3), 1e-12 + 1e-6 * std::abs(mu.d_temperature));
}

} // namespace

TEST(FrictionLaw, SpeedAlone) {
  const FrictionLaw law{.mu_slow = 0.03, .mu_fast = 0.08, .rate = 20};
  EXPECT_EQ(law.at({.speed = 0}).value, 0.03);
  EXPECT_NEAR(law.at({.speed = 0.1}).value, 0.08 - 0.05 * std::exp(-2.0), 1e-15);
  EXPECT_NEAR(law.at({.speed = 10}).value, 0.08, 1e-12);
  EXPECT_NEAR(law.at({.speed = 0.1}).value, coefficient_at_speed(0.1, 0.03, 0.08, 20.0), 1e-16);
  // What the law does not read must not matter.
  const FrictionLaw constant{.mu_slow = 0.07, .mu_fast = 0.07, .rate = std::nan("")};
  EXPECT_EQ(constant.at({0.3, std::nan(""), std::nan("")}).value, 0.07);
  EXPECT_NO_THROW(constant.validate());
  EXPECT_TRUE(constant.holds());
  EXPECT_FALSE((FrictionLaw{.mu_slow = 0, .mu_fast = 0.08, .rate = 20}.holds()));
}

TEST(FrictionLaw, FactorsAreThePublishedOnes) {
  EXPECT_DOUBLE_EQ(pressure_factor(50e6, 50e6), 1);
  EXPECT_NEAR(pressure_factor(100e6, 50e6), 0.7, 1e-12);
  EXPECT_NEAR(pressure_factor(0.0, 50e6), 1 / 0.7, 1e-12);
  EXPECT_NEAR(temperature_factor(20.0), 1, 2e-3);
  EXPECT_NEAR(temperature_factor(250.0), 0.79 * (std::pow(0.7, 5) + 0.4), 1e-12);
  EXPECT_NEAR(temperature_factor(1e4), 0.316, 1e-3);
  // k_v = 1 - 0.5 exp(-a v) is the law over speed from half of its fast value.
  EXPECT_NEAR(coefficient_at_speed(0.02, 0.04, 0.08, 100.0), 0.08 * (1 - 0.5 * std::exp(-2.0)), 1e-15);
}

TEST(FrictionLaw, ProductAndDerivatives) {
  FrictionLaw law{.mu_slow = 0.04, .mu_fast = 0.08, .rate = 30, .reference_pressure = 20e6, .by_temperature = true};
  law.area = 0.01;
  const Sliding s{0.05, 45e6, 130};
  EXPECT_NEAR(law.at(s).value,
              coefficient_at_speed(0.05, 0.04, 0.08, 30.0) * pressure_factor(45e6, 20e6) * temperature_factor(130.0),
              1e-15);
  expect_consistent(law, s);
  law.reference_pressure.reset();
  expect_consistent(law, s);
  law.table = table();
  for (const Sliding &at :
       {Sliding{0.05, 30e6, 80}, Sliding{0.5, 20e6, 20}, Sliding{3, 80e6, 20}, Sliding{0.5, 1e6, 20}})
    expect_consistent(law, at);
}

TEST(FrictionLaw, ForceUnderALoad) {
  FrictionLaw law{.reference_pressure = 30e6};
  law.area = 0.02;
  for (const double N : {0.0, 2e5, 9e5}) {
    const auto force = [&](double normal) { return normal * law.under(normal, 0.1, 20).value; };
    const double step = 10;
    EXPECT_NEAR(law.d_force(law.under(N, 0.1, 20), N),
                (force(N + step) - force(std::max(0.0, N - step))) / (N > 0 ? 2 * step : step), 1e-6);
  }
  EXPECT_NEAR(law.under(6e5, 0.1, 20).value, 0.07, 1e-15); // 30 MPa
}

TEST(FrictionLaw, RefusesWithNumbers) {
  try {
    FrictionLaw{.mu_slow = 0.12, .mu_fast = 0.08, .rate = 20}.validate();
    FAIL();
  } catch (const InputError &e) {
    EXPECT_NE(std::string(e.what()).find("mu_slow 0.120000 exceeds mu_fast 0.080000"), std::string::npos);
  }
  EXPECT_THROW((FrictionLaw{.mu_slow = -0.1, .mu_fast = 0.08, .rate = 20}.validate()), InputError);
  EXPECT_THROW((FrictionLaw{.mu_slow = 0.05, .mu_fast = 0.08}.validate()), InputError);
  EXPECT_THROW((FrictionLaw{.reference_pressure = 1e6}.validate()), InputError);
}
