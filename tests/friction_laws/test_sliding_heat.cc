// The steel under a slider against Carslaw and Jaeger's closed form, and a pulse train against the convolution itself.
#include "laws/friction/sliding_heat.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace rimpact::friction;

namespace {

constexpr double flux = 2e6; // [W/m^2]

/// T - T_0 = 2 q sqrt(D t / pi) / k.
double under_constant_flux(const HeatSink &sink, double time) {
  return 2 * flux * std::sqrt(sink.diffusivity * time / std::numbers::pi) / sink.conductivity;
}

} // namespace

TEST(SlidingHeat, ConstantFluxIsTheClosedForm) {
  const HeatSink sink;
  const SlidingHeat heat(sink);
  for (const double time : {0.01, 0.03, 0.1, 0.5, 1.0, 3.0, 10.0, 40.0, 100.0}) {
    const auto modes = heat.after({}, flux, time);
    EXPECT_NEAR((heat.temperature(modes.data()) - 20) / under_constant_flux(sink, time), 1, 5e-3) << time;
  }
  HeatSink warm = sink;
  warm.at_start = 35, warm.conductivity = 9;
  const SlidingHeat other(warm);
  EXPECT_NEAR((other.temperature(other.after({}, flux, 1).data()) - 35) / under_constant_flux(warm, 1), 1, 5e-3);
}

TEST(SlidingHeat, AnEndedFluxCoolsByTheDifferenceOfTwoRoots) {
  const HeatSink sink;
  const SlidingHeat heat(sink);
  for (const double later : {0.05, 0.5, 5.0, 30.0}) {
    const auto modes = heat.after(heat.after({}, flux, 0.4), 0, later);
    const double exact = under_constant_flux(sink, 0.4 + later) - under_constant_flux(sink, later);
    EXPECT_NEAR(heat.temperature(modes.data()) - 20, exact, 5e-3 * under_constant_flux(sink, 0.4 + later)) << later;
  }
}

TEST(SlidingHeat, StepsAddUpAndRatesAreTheirs) {
  const SlidingHeat heat;
  HeatModes many{}, rate;
  for (int i = 0; i < 1000; ++i) many = heat.after(many, flux, 1e-3);
  const auto once = heat.after({}, flux, 1);
  const auto before = heat.after(once, flux, 1e-6);
  heat.rates(once.data(), flux, rate.data());
  for (int i = 0; i < n_heat_modes; ++i) {
    EXPECT_NEAR(many[i], once[i], 1e-9 * (1 + once[i])) << i;
    EXPECT_NEAR(rate[i], (before[i] - once[i]) / 1e-6, 1e-3 * (1 + std::abs(rate[i]))) << i;
  }
}

TEST(SlidingHeat, AContactIsTheSquareOfItsArea) {
  EXPECT_TRUE(passes_over(0.088, 0.1)); // sqrt(pi) / 2 = 0.886
  EXPECT_FALSE(passes_over(0.089, 0.1));
}
